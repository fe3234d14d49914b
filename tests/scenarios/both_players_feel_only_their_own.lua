-- One player lifts while the other shoots. Each hand feels the player's own wand and nothing of the other's.
match {players = {"script", "script"}, forces = {100, 100}}
clear_props()
local lifter, shooter = wizard(1), wizard(2)
lifter:place {8, 0, 16}
lifter:face(-90, 0)
shooter:place {8, 0, -16}
shooter:face(-90, 0)
local thing = spawn {kind = "box", size = {0.8, 0.8, 0.8}, mass = 40, at = {11, 0.4, 16}}
trace("own", {"1.force_x", "1.force_y", "1.force_z", "2.force_x", "2.force_y", "2.force_z"})
lifter:press("wand_4")
lifter:aim(thing)
wait(0.3)
lifter:hold("fire")
wait(0.3)
lifter:look(0, 10)
wait(1)
local silent, swung = 0, 0
for i = 1, 500 do
    tick()
    silent = silent + length(shooter:force())
    swung = swung + length(lifter:force())
end
expect_near(silent, 0, 0, "no force on the hand without the thing")
expect(swung > 100, "force on the hand with the thing")
wait(1.5)
local still = lifter:force()
shooter:hold("fire")
local kicks, shaken = 0, 0
for i = 1, 1000 do
    tick()
    kicks = kicks + shooter:force().z * 0.001
    shaken = math.max(shaken, distance(lifter:force(), still))
end
shooter:release("fire")
expect_near(kicks, 8 * 2 / math.pi * 1.2 * 0.015, 0.012, "impulse of eight bolts")
expect(shaken < 0.01, "the lifting hand does not feel the bolts")
