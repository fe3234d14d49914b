-- A heart gives 50 HP, also above 100 HP, but never above 150 HP. Health above 100 HP decays by 1 HP a
-- second.
match {players = {"script", "script"}}
trace("health", {"1.health"})
local me = wizard(1)
me:place {18.2, 0, 4}
me:face(0)
me:move(0, 1)
local taken = expect_event {kind = "power_up", subject = 1, within = 3}
me:stop()
expect_near(taken.detail, 1, 0, "kind of the power-up")
expect_near(taken.amount, 50, 0)
expect_near(me:health(), 150, 0.02)
wait(10)
expect_near(me:health(), 140, 0.03, "health lost per second")
wait(34.9)
local before = me:health()
expect_near(before, 105.1, 0.05)
local again = expect_event {kind = "power_up", subject = 1, within = 0.2}
expect_near(again.time - taken.time, 45, 0.008, "time until the heart is back")
expect_near(again.amount, 45, 0.02, "health at the cap")
expect_near(me:health(), 150, 0.02)
me:move(0, -1)
wait(1)
me:stop()
wait(52)
expect_near(me:health(), 100, 0, "health falls to 100 and no further")
