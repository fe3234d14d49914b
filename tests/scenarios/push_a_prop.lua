-- A wizard who walks into a crate pushes it: a light one at nearly the walking speed, a heavy one slowly.
-- Friction stops a pushed crate.
match {players = {"script", "script"}}
clear_props()
local me = wizard(1)

local function push(mass)
    local crate = spawn {kind = "box", size = {0.8, 0.8, 0.8}, mass = mass, at = {-12, 0.4, 16}}
    me:place {-14, 0, 16}
    me:face(-90)
    wait(0.3)
    trace("push_" .. mass, {"1.x", "t1.x", "t1.speed"})
    local from = crate:position()
    me:move(0, 1)
    wait(1.2)
    local speed = crate:velocity().x
    me:stop()
    wait(2)
    local moved = crate:position().x - from.x
    expect(length(crate:velocity()) < 0.05, mass .. " kg: at rest")
    expect(crate:position().y > 0.35 and crate:position().y < 0.9, mass .. " kg: still on the floor")
    crate:place {14, 3, mass / 10}
    return moved, speed
end

local light, light_speed = push(8)
local heavy, heavy_speed = push(100)
expect(light > 0.5, "8 kg moved " .. light .. " m")
expect(heavy > 0.02, "100 kg moved " .. heavy .. " m")
expect(light > 2 * heavy, "the light crate moves farther")
expect(light_speed > heavy_speed and light_speed < 6, "the light crate moves faster")

-- A push by an impulse: 50 N s on 25 kg give 2 m/s. Friction of 0.8 * 0.8 stops it after v^2 / (2 mu g).
local crate = spawn {kind = "box", size = {1, 0.4, 1}, mass = 25, at = {-14, 0.2, 0}}
wait(0.5)
local from = crate:position()
crate:push {0, 0, 50}
tick()
expect_near(crate:velocity().z, 2, 0.02, "speed of impulse divided by mass")
wait(1.5)
expect_near(crate:position().z - from.z, 2 * 2 / (2 * 0.64 * 9.81), 0.03, "distance until friction stops the crate")
