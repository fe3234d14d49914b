-- A brew more than twice as viscous as the pure one slows wizards within 5 m of it, both of them, to 0.75 of
-- their pace.
match {players = {"script", "script"}}
clear_props()
local me, foe = wizard(1), wizard(2)
local function pace(who, x)
    who:place {x, 0, 4}
    who:face(0, 0)
    wait(0.3)
    who:move(1, 0)
    wait(0.3)
    local speed = length(who:velocity())
    who:stop()
    wait(0.3)
    return speed
end
local usual = pace(me, -3)
foe:place {15, 0, -15}
me:drop_in({7, 0, 0}, {2.2, 0, 0})  -- resin
me:release("stir")
wait(0.5)
expect(brew().viscosity > 2, "viscosity of the thick brew: " .. brew().viscosity)
expect_near(pace(me, -3) / usual, 0.75, 0.03)
me:place {-12, 0, -4}
expect_near(pace(foe, -3) / usual, 0.75, 0.03, "a thick brew slows both wizards")
expect_near(pace(me, -12) / usual, 1, 0.03, "a distant wizard is not slowed")
