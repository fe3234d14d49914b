-- A player's own gesture, which the match has from the profile, stands for the shipped one: player 1 casts the shield by
-- a triangle in the place of the circle. Player 2 has no gesture of their own, so the circle counts.
local triangle = {{-1, -0.7}, {0, 1}, {1, -0.7}, {-1, -0.7}}
match {players = {"script", "script"}, gestures = {{circle = triangle}}}
local me, foe = wizard(1), wizard(2)
me:cast(triangle, {seconds = 1.2})
expect_event {kind = "cast", by = 1, within = 0.1}
expect_near(me:ward(), 30, 0, "the shield of the circle, by the own gesture")
foe:cast(triangle, {seconds = 1.2})
expect_event {kind = "unread", by = 2, within = 0.1}
expect_near(foe:ward(), 0, 0, "no shield by another player's gesture")
foe:cast("circle", {seconds = 1.2})
expect_near(foe:ward(), 30, 0, "the shipped circle of the other player")
wait(7)
local before = me:focus()
me:cast("circle", {seconds = 1.2})
expect_event {kind = "unread", by = 1, within = 0.1}
expect_near(me:ward(), 0, 0, "no shield by the gesture that was replaced")
expect(me:focus() >= before, "a miss costs no focus")
me:cast("v", {seconds = 1})
expect(time() < 30, "the other shipped gestures are still there")
