-- A power-up that would give nothing stays until it would give something.
match {set = {"wizard.health.start=150"}, players = {"script", "script"}}
local me, foe = wizard(1), wizard(2)

local function over(place)
    me:place {place[1], 0, place[3] + 3}
    me:face(0, 30)
    me:move(0, 1)
    wait_until(function() return me:position().z < place[3] end, 3)
    me:stop()
    wait(0.2)
end

over {15, 0, 8.5}
expect_near(me:health(), 150, 0)
expect_near(#events("power_up"), 0, 0, "no vial is picked up at the health cap")
over {-2, 0, 14}
expect_near(me:energy(), 60, 0)
expect_near(#events("power_up"), 0, 0, "no spark is picked up with all wands full")
for _, p in ipairs(power_ups()) do expect(p.there, "a " .. p.kind .. " has gone") end

-- After a shot the spark's energy fits.
me:press("fire")
local spark = expect_event {kind = "power_up", subject = 1, within = 0.1}
expect_near(spark.amount, 1.5, 0.05)

-- A dead wizard picks nothing up.
foe:place {15, 130, 8.5}
wait_until(function() return foe:dead() end, 8)
wait(1)
expect_near(#events("power_up"), 1, 0, "a dead wizard picks nothing up")
