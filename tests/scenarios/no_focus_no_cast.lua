-- A spell that the focus does not pay for is not cast, and takes no focus. A harsh stroke needs more of it.
match {players = {"script", "script"}, set = {"casting.focus.cap=30", "casting.focus.regain_per_s=0"}}
local me = wizard(1)
me:cast("circle", {seconds = 0.35})
local missing = expect_event {kind = "unfocused", by = 1, within = 0.1}
expect_near(missing.amount, 7.5, 1e-9, "a harsh shield costs 37.5 of 30")
expect_near(me:focus(), 30, 0, "none is spent")
expect(me:ward() == 0, "there is no shield")
me:cast("circle", {seconds = 1.2})
expect_event {kind = "cast", by = 1, within = 0.1}
expect_near(me:focus(), 5, 1e-9, "a gentle one costs 25")
me:cast("v", {seconds = 1})
expect_event {kind = "unfocused", by = 1, within = 0.1}
expect_near(me:focus(), 5, 1e-9, "5 do not pay for a push")
expect(#events {kind = "cast", by = 1} == 1, "one spell was cast")
