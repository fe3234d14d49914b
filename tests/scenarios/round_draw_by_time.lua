-- Without Boil-over, a round with equal kills at the end of its time has no winner. A pause does not use up time.
match {match = "quick", set = {"quick.seconds=3", "quick.boil_over.seconds=0"}, players = {"script", "script"}}
wizard(1):move(0, 1)
wait(1)
wizard(1):stop()
pause(2)
wait(5)
expect(paused() and not round_over(), "a pause takes no time of the round")
pause(1)
local ending = expect_event {kind = "round_end", within = 3}
expect_near(ending.time, 3, 0.008, "time of play at the end")
local over, how, winner = round_over()
expect(over and how == "time", "the round ends on time")
expect(winner == nil, "the round is a draw")
