-- A held thing is moved by force alone: a wall stops it, the spring between it and the hand is drawn out, and the hand feels that: on the whole
-- device 300 N/m, 20 : 1 in the world. Let go by the wall, it has not gone through.
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
expect_near(length(me:force()), 0.2, 0.02, "only its weight, by the fader")
local free = thing:position().x
-- To the wall: its face is at x = 20, so the thing's middle gets to 19.5 and no farther.
me:move(0, 1)
wait_until(function() return me:position().x > 15 + (19.5 - free) + 0.1 end, 3)
me:stop()
wait(0.6)
expect_near(thing:position().x, 19.5, 0.01, "the wall holds it")
local stretch = (me:position().x - 15) - (19.5 - free)
expect(stretch > 0.08 and stretch < 0.5, "the wizard went on")
-- The hand gives way, so the spring is a little shorter than the way.
local pull = me:force().z
expect(pull > 0.5, "it pulls the hand back")
expect_near(pull, 300 * (stretch / 20 - me:hand().z), 0.15, "by Hooke's law")
wait(1)
expect_near(thing:position().x, 19.5, 0.01, "and stays so")
me:release("fire")
wait(1)
expect(thing:position().x < 19.51)
expect_near(length(me:force()), 0, 1e-9)
expect(me:created() <= 0.02, "the spring has created no energy")
