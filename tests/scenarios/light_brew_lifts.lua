-- Down and mist make a brew lighter than 0.8 of the pure one. A wizard near it falls more slowly.
match {players = {"script", "script"}, set = {"cauldron.brewing.niche_radius_m=0.5"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
local function fetch(x)
    me:drop_in({x, 0, 0}, {-2.2, 0, 0})
    me:release("stir")
    wait(0.1)
end
-- Greatest height in a jump at the place x (m).
local function jump(x)
    me:place {x, 0, 3}
    wait(0.3)
    local high = 0
    me:press("jump")
    for _ = 1, 900 do
        tick()
        high = math.max(high, me:position().y)
    end
    return high
end
local usual = jump(-2.5)
fetch(-9.5)
fetch(9.5)
expect(#brew().contents == 2)
wait(1)
expect(brew().density < 0.8, "density of the light brew: " .. brew().density)
local near, far = jump(-2.5), jump(-12)
expect_near(far, usual, 0.03, "full gravity far from the brew")
expect_near(near / usual, 1 / 0.7, 0.1, "gravity times 0.7 near the brew")
