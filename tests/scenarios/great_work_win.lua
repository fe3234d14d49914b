-- A wizard who holds Azoth and Lens for 30 s wins the round. Both players are told when it begins. A pause stops its clock.
match {players = {"script", "script"}, seed = 1}
local me = wizard(1)
give(1, "azoth")
wait(1)
expect(carver(1).great_work == 0, "one half is not enough")
give(1, "lens")
local begun = expect_event {kind = "work_begun", subject = 1, within = 0.1}
expect_near(begun.amount, 30, 1e-9, "seconds to hold")
wait(10)
expect_near(carver(1).great_work, 10, 0.02, "seconds held")
pause(2)
wait(5)
expect_near(carver(1).great_work, 10, 0.1, "a pause does not count")
pause(2)
wait(19.5)
expect(not round_over(), "not yet")
wait(1)
local over, ending, winner = round_over()
expect(over and ending == "great_work" and winner == 1, "the round is won by the Great Work: " .. tostring(ending))
expect_event {kind = "work_done", subject = 1}
expect_event {kind = "round_end", subject = 1}
expect(#events {kind = "work_broken"} == 0, "nobody broke it")
