-- A seek into a search of the orb, into the drawing of a curve and to before anybody scried leads to the same state as playing
-- so far. The wizard walks to the orb.
match {seed = 4, players = {"script", "script"}}
local me = wizard(1)
local here = me:position()
if math.abs(here.x + 15) > 0.5 then me:walk_to(-15, here.z) end
me:walk_to(-15, 0)
me:walk_to(-16.7, 0)
wait(0.3)
local before = now()
me:scry(4, 1)
expect(me:scrying().modes[2] == "viscosity", "two modes are worn")
me:hand_to({0.02, -0.01, 0.01}, 0.08)
local searching = now()
local drawn = me:curve(1, 15)
me:hold("trace")
wait(0.05)
for _ = 1, 200 do me:stroke(1, 1) tick() end
local drawing = now()
expect(me:scrying().drawing, "the hand draws")
for _ = 1, 300 do me:stroke(-2, 0) tick() end
me:release("trace")
wait(0.2)
expect(me:curve(1, 15) ~= drawn, "the curve has changed")
me:hand_to((me:core()), 0.08)
wait(1)
local near = now()
wait(0.7)
expect(me:scrying().near, string.format("the probe is %.3f m from the core", me:scrying().distance))
expect_event {kind = "scried", subject = 1}
me:release("stir")
wait(0.3)
check_seek {ticks = {before, searching, drawing, near, now()}}
