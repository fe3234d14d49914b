-- A fall from h metres ends at v = sqrt(2 g h). It costs 12 (v - 7.5) HP above 7.5 m/s and nothing below.
match {players = {"script", "script"}}
clear_props()
trace("falls", {"1.y", "1.vy", "1.health"})

local g, safe, per = 9.81, 7.5, 12
local me = wizard(1)
for _, v in ipairs {4, 6, 7.3, 8, 8.5, 9, 9.4, 9.9} do
    local before, told = me:health(), #events("fall")
    me:place {-14, v * v / (2 * g), 9}
    wait_until(function() return not me:grounded() end, 0.1)
    wait_until(function() return me:grounded() end, 5)
    wait(0.2)
    local wanted = math.max(0, per * (v - safe))
    expect_near(before - me:health(), wanted, 0.05 * per, "HP lost at " .. v .. " m/s")
    expect_near(#events("fall") - told, wanted > 0 and 1 or 0, 0, "one event for each hard landing")
end
expect(not me:dead(), "the wizard is alive")

-- A wizard's own jump never hurts.
local before = me:health()
me:press("jump")
wait(1.5)
expect_near(me:health(), before, 0, "jumping does no harm")

-- A fall from high enough kills, and the wizard who dies by it loses a kill.
me:place {-14, 60, 9}
expect_event {kind = "death", subject = 1, within = 6}
expect_near(me:kills(), -1, 0)
