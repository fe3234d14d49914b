-- A wizard swings across the pit from an anchor above it. The hand feels the rope's tension in the rope's
-- direction, and the wizard lands on the other side. The force scale is half its usual value, so that the
-- device can hold it for ten seconds.
match {players = {"script", "script"}, set = {"haptics.share=1", "swing.hand.newtons_per_newton=0.0005"}}
local me = wizard(1)
wizard(2):place {-15, 0, -15}
me:place {4, 0, 5}
me:face(180, 0)
trace("swing", {"1.x", "1.y", "1.z", "1.vy", "1.vz", "1.force_x", "1.force_y", "1.force_z", "1.energy"})
wait(0.3)
me:press("wand_5")
me:aim {4, 7, 9}
wait(0.1)
me:hold("fire")
wait_until(function() return me:position().z > 9 end, 3)
expect(me:position().y > -0.5, "the wizard hangs above the pit")
me:look(0, -50)
wait_until(function() return me:position().z > 11 end, 3)
me:release("fire")
me:move(0, 1)
wait_until(function() return me:position().z > 12.2 and me:grounded() end, 3)
me:stop()
expect(me:position().y > -0.05, "the wizard lands on the other side")
expect_near(me:health(), 100, 0, "the swing does no harm")
expect(me:energy() < 75, "the swing costs energy")
wait(0.2)
expect_near(length(me:force()), 0, 1e-9, "no force without the rope")

-- Hangs until all motion has stopped.
me:place {4, 0, 8.1}
me:face(180, 0)
wait(0.05)
me:aim {4, 7, 9}
wait(0.1)
me:hold("fire")
wait(6)
-- On a circle the rope carries its part of the weight and the centripetal force: m (g cos + v^2 / r).
local felt, law, count = 0, 0, 0
for i = 1, 4000 do
    tick()
    local eye, v = me:eye(), me:velocity()
    local y, z = 7 - eye.y, 9 - eye.z
    local r = length {x = 4 - eye.x, y = y, z = z}
    local along = (v.y * y + v.z * z) / r
    felt, count = felt + length(me:force()), count + 1
    law = law + 75 * (9.81 * y / r + (v.y * v.y + v.z * v.z - along * along) / r)
end
expect_near(felt / law, 0.0005, 0.00001, "force on the hand is the scaled tension of the rope")
expect(me:force().y > 0, "the force points up to the anchor")
