-- Death breaks the Great Work: its two halves (Azoth and Lens) are lost, and the round goes on. With both
-- halves again the 30 s begin anew.
match {players = {"script", "script"}, seed = 1}
local me, foe = wizard(1), wizard(2)
clear_props()
me:place {-8, 0, 8}
foe:place {-8, 0, 14}
give(1, "azoth")
give(1, "lens")
expect_event {kind = "work_begun", subject = 1, within = 0.1}
wait(20)
foe:aim(me)
foe:hold("fire")
wait_until(function() return me:dead() end, 9)
foe:release("fire")
expect_event {kind = "lens_lost", subject = 1, within = 0.1}
expect_event {kind = "work_broken", subject = 1, within = 0.1}
expect(not carver(1).lens and not me:potions().work_half, "both halves are lost")
expect(carver(1).great_work == 0, "the clock stands")
wait(4)
give(1, "azoth")
give(1, "lens")
wait(12)
expect(not round_over(), "30 s after the first beginning nobody has won")
expect_near(carver(1).great_work, 12, 0.02, "the clock has begun anew")
wait(19)
local over, ending, winner = round_over()
expect(over and ending == "great_work" and winner == 1, "then the round is won")
