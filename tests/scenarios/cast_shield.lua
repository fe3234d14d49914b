-- A circle casts a shield that takes harm in its wizard's place. A fast circle is harsh: the shield is stronger and costs
-- more focus. A scribble casts nothing and costs nothing.
match {players = {"script", "script"}}
clear_props()
local me, foe = wizard(1), wizard(2)
me:place {0, 0, 12}
foe:place {3, 0, 12}
foe:face(math.pi / 2, 0)
expect_near(me:focus(), 100, 0, "a new wizard has all of the focus")
me:cast("circle", {seconds = 1.2})
expect_event {kind = "cast", by = 1, within = 0.1}
expect_near(me:ward(), 30, 0, "a gentle shield")
expect_near(me:focus(), 75, 1, "its focus")
foe:aim(me)
foe:hold("fire")
wait_until(function() return me:health() < 100 end, 3)
foe:release("fire")
expect_event {kind = "held_off", subject = 1, by = 2, within = 1}
expect_near(me:health(), 94, 0, "five bolts are held, the sixth hurts")
wait(7)
me:cast("circle", {seconds = 0.35})
expect_near(me:ward(), 42, 1e-9, "a harsh shield")
expect_near(me:focus(), 62.5, 3, "its focus")
local before = me:focus()
me:cast({{0, 0}, {0.3, 0.2}, {-0.2, 0.5}, {1, 0.1}, {0.8, 0.9}, {-0.5, -0.2}, {0, 1}}, {seconds = 1})
expect_event {kind = "unread", by = 1, within = 0.1}
expect(me:focus() >= before, "a miss costs no focus")
