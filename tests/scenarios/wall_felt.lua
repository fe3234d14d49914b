-- The bowl's wall holds the ladle in and pushes as hard as it is pressed. The brew is thick, so that it soon
-- rests.
match {players = {"script", "script"}, set = {"haptics.share=1", "cauldron.brew.viscosity_m2_s=0.3"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
me:place {-2.2, 0, 0}
me:hold("stir")
trace("wall", {"1.hand_x", "1.hand_z", "1.force_x", "1.force_z"})
wait(0.3)
me:draw(3, -1, 0.3)  -- to the right and back, where the wall is near
wait(1)
local hand, force, ladle, middle = me:hand(), me:force(), me:ladle(), brew().middle
-- Place of the hand that belongs to the ladle's place, at 15 m of the ladle per metre of the hand. The wizard
-- looks along +x, and a resting hand holds the ladle 0.35 m before the bowl's middle.
local held = {x = (ladle.z - middle.z) / 15, z = (middle.x - 0.35 - ladle.x) / 15}
local off = length {hand.x - held.x, 0, hand.z - held.z}
expect(off > 0.001, "the wall holds back the hand")
expect(length(force) > 0.2, "force of the wall: " .. length(force))
expect_near(force.x, -250 * (hand.x - held.x), 0.05, "force of a spring of 250 N/m")
expect_near(force.z, -250 * (hand.z - held.z), 0.05)
expect(length {ladle.x - middle.x, 0, ladle.z - middle.z} < 1.36, "the ladle stays in the bowl")
expect(me:created() <= 0.02, "the wall creates no energy")
