-- Only forces move a held thing. A wall stops it, the spring to the hand stretches, and the hand feels that:
-- 300 N/m at the hand, whose way is 20 times as long in the world. When the hand lets go, the thing has not
-- passed through the wall.
match {players = {"script", "script"}, forces = {100, 100}}
clear_props()
local me = wizard(1)
wizard(2):place {-15, 0, -15}
me:place {15, 0, 16}
me:face(-90, 0)
local thing = spawn {kind = "box", size = {1, 1, 1}, mass = 20, at = {18, 0.5, 16}}
trace("wall", {"1.force_x", "1.force_y", "1.force_z", "1.hand_z", "t1.x", "t1.z"})
wait(0.3)
me:press("wand_4")
me:aim(thing)
wait(0.1)
me:hold("fire")
wait(0.2)
me:look(0, 10)
wait(1.5)
expect_near(length(me:force()), 0.2, 0.02, "only the weight is felt, through the fader")
local free = thing:position().x
-- Moves to the wall. Its face is at x = 20, so the thing's middle stops at 19.5.
me:move(0, 1)
wait_until(function() return me:position().x > 15 + (19.5 - free) + 0.1 end, 3)
me:stop()
wait(0.6)
expect_near(thing:position().x, 19.5, 0.01, "the wall stops the thing")
local stretch = (me:position().x - 15) - (19.5 - free)
expect(stretch > 0.08 and stretch < 0.5, "the wizard walks on")
-- The hand gives way, so the spring is a little shorter than the distance.
local pull = me:force().z
expect(pull > 0.5, "the spring pulls the hand back")
expect_near(pull, 300 * (stretch / 20 - me:hand().z), 0.15, "force of the stretched spring")
wait(1)
expect_near(thing:position().x, 19.5, 0.01, "the thing stays at the wall")
me:release("fire")
wait(1)
expect(thing:position().x < 19.51)
expect_near(length(me:force()), 0, 1e-9)
expect(me:created() <= 0.02, "the spring creates no energy")
