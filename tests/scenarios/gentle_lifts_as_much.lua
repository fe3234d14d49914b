-- The force limit changes only the force on the hand. A player with little or no force lifts the same thing
-- as high and as fast.
match {players = {"script", "script"}, forces = {100, 20}}
clear_props()
local strong, gentle = wizard(1), wizard(2)
strong:place {8, 0, 16}
strong:face(-90, 0)
gentle:place {8, 0, -16}
gentle:face(-90, 0)
local one = spawn {kind = "box", size = {0.8, 0.8, 0.8}, mass = 90, at = {11, 0.4, 16}}
local two = spawn {kind = "box", size = {0.8, 0.8, 0.8}, mass = 90, at = {11, 0.4, -16}}
trace("lift", {"1.force_y", "2.force_y", "1.energy", "2.energy", "t1.y", "t2.y"})
wait(0.3)
strong:press("wand_4") gentle:press("wand_4")
strong:aim(one) gentle:aim(two)
wait(0.1)
strong:hold("fire") gentle:hold("fire")
wait(0.2)
strong:look(0, 15) gentle:look(0, 15)
local felt, clipped = 0, 0
for i = 1, 2000 do
    tick()
    felt = math.max(felt, length(strong:force()))
    clipped = math.max(clipped, length(gentle:force()))
end
expect(one:position().y > 0.8, "the thing is lifted")
expect_near(two:position().y, one:position().y, 0.05, "both things are at the same height, apart from the way of the hands")
expect_near(strong:force().y, -0.01 * 90, 0.05, "weight felt through the fader")
expect(felt > 1.0, "the strong hand feels the thing")
expect(clipped <= 0.2 * 3.3 + 1e-9, "the gentle hand's force stays within its cap")
expect(clipped > 0.3)
