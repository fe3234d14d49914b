-- At the end of the time the player with more kills wins. Who dies by a fall loses one kill.
match {match = "quick", set = {"quick.seconds=6"}, players = {"script", "script"}}
clear_props()
local me, foe = wizard(1), wizard(2)
foe:place {-14, 70, -9}
expect_event {kind = "death", subject = 2, within = 5}
expect_near(foe:kills(), -1, 0)
expect_near(me:kills(), 0, 0)
wait_until(function() return time() > 5.98 end, 3)
expect(not round_over(), "the round is not over yet")
local ending = expect_event {kind = "round_end", within = 0.1}
expect_near(ending.time, 6, 0.008, "time of play at the end")
local over, how, winner = round_over()
expect(over and how == "time", "the round ends on time")
expect_near(winner, 1, 0, "the player with more kills wins")
local at = time()
wait(1)
expect_near(time(), at, 0, "time stands still after the round")
