-- A held thing in the path of a bolt stops the bolt. The hand feels the blow, and the wizard is not hurt.
match {players = {"script", "script"}}
clear_props()
local me, foe = wizard(1), wizard(2)
me:place {8, 0, 16}
me:face(-90, 0)
foe:place {18, 0, 16}
foe:face(90, 0)
local shield = spawn {kind = "box", size = {0.3, 1.6, 1.6}, mass = 30, at = {11, 0.8, 16}}
trace("shield", {"1.force_x", "1.force_y", "1.force_z", "1.health", "t1.x", "t1.vx"})
wait(0.3)
me:press("wand_4")
me:aim(shield)
wait(0.1)
me:hold("fire")
wait(0.1)
me:look(0, 8)
wait(1.5)
local still = me:force()
foe:aim(me)
wait(0.2)
local health, shots = me:health(), foe:shots()
foe:press("fire")
local strongest, pushed = 0, 0
for i = 1, 500 do
    tick()
    strongest = math.max(strongest, math.abs(me:force().z - still.z))
    pushed = math.min(pushed, shield:velocity().x)
end
expect(foe:shots() > shots, "the foe has shot")
expect_near(me:health(), health, 0, "no shot hit a wizard")
expect_near(#events("bolt_hit"), 0, 0)
expect_near(pushed, -3 / 30, 0.02, "momentum of 3 N s in 30 kg")
-- A blow gives 0.1 N for each N s, of which 45 % are felt, and the spring gives way a little.
expect_near(strongest, 0.1 * 3 * 0.45, 0.03, "the hand feels the bolt")
me:release("fire")
wait(0.3)
foe:press("fire")
wait(0.5)
expect(me:created() <= 0.02, "the spring creates no energy")
