-- A blast with charge c costs a struck wizard 15 + 55 c HP. A nearby wizard loses at most 30 % of that,
-- falling evenly to nothing at a distance of 2 + 1.5 c m, and nothing behind a wall. A blast pushes things
-- and flies at 18 + 14 c m/s. A wizard who shoots at their own feet is hurt, and the hurt is their own.
match {players = {"script", "script"}, set = {"wizard.health.start=1000", "wizard.health.cap=1000", "blast.energy.cap=600"}}
trace("health", {"1.health", "2.health", "2.speed", "1.energy", "1.force_z"})
local me, foe = wizard(1), wizard(2)
local ball, radius, half_axis = 0.1, 0.35, 0.55
clear_props()
me:press("wand_2")

local function shoot(at, held)
    me:aim(at)
    wait(0.3)
    local energy = me:energy()
    me:hold("fire")
    wait(held)
    expect_near(me:force().z, 0.45 * 2.6 * me:readiness(), 0.03, "force on the hand grows with the charge")
    me:release("fire")
    local shot = expect_event {kind = "shot", by = 1, within = 0.02}
    local c = (energy - me:energy() - 8) / 17
    tick()
    local ball_now = missiles()[1]
    if ball_now then expect_near(length(ball_now.velocity), 18 + 14 * c, 1e-9, "speed of the ball") end
    local burst = expect_event {kind = "burst", by = 1, within = 3}
    expect_near(burst.amount, 2 + 1.5 * c, 1e-9, "radius of the burst")
    tick()  -- the push moves bodies in the next tick
    return c, burst
end

local function hurt_of(who, burst)
    for _, hit in ipairs(events {kind = "blast_hit", subject = who}) do
        if hit.time == burst.time then return hit.amount, hit.by end
    end
    return 0
end

-- A struck wizard.
for _, held in ipairs {0.312, 0.95, 1.7} do
    me:place {-15, 0, 15}
    foe:place {-15, 0, 8}
    local c, burst = shoot(foe, held)
    local amount, by = hurt_of(2, burst)
    expect_near(amount, 15 + 55 * c, 1e-9, "damage to the struck wizard")
    expect_near(by, 1, 0)
    expect(foe:velocity().z < -1, "the burst pushes the struck wizard away")
    expect_near(foe:velocity().z, -math.min((120 + 180 * c) / 75, 8), 0.1)
    wait(1)
end

-- A nearby wizard, at several distances from the burst on the ground.
local seen = {}
for i, off in ipairs {0.7, 1.2, 1.8, 2.5, 3.5, 4.5} do
    me:place {-15, 0, 15}
    foe:place {-15 + off, 0, 8}
    wait(0.2)
    local place_of_foe = foe:centre()
    local c, burst = shoot({-15, 0, 8}, 1.7)
    -- Distance between the surfaces of the ball and the wizard. The capsule's axis is 1.1 m long, and its
    -- lower end is nearest.
    local low = {place_of_foe.x, place_of_foe.y - half_axis, place_of_foe.z}
    local d = math.max(0, distance(burst.place, low) - radius - ball)
    local amount = hurt_of(2, burst)
    expect_near(amount, 0.3 * 70 * math.max(0, 1 - d / 3.5), 0.02, "splash damage at distance " .. i)
    seen[i] = amount
    expect(i == 1 or amount <= seen[i - 1], "splash damage falls with distance")
    wait(0.5)
end
expect(seen[1] > 15 and seen[5] > 0.1 and seen[6] == 0, "splash damage falls from nearly all to nothing")

-- A wizard behind a wall: neither harm nor push.
me:place {-15, 0, 15}
foe:place {-13.4, 0, 8}
local wall = spawn {kind = "box", size = {0.1, 2.5, 4}, mass = 9000, at = {-14.2, 1.25, 8}, friction = 2}
wait(0.5)
local _, burst = shoot({-14.7, 0, 8}, 1.7)
expect_near(hurt_of(2, burst), 0, 0, "a wall shields from splash damage")
expect(length(foe:velocity()) < 0.05, "a wall shields from the push")
wall:place {0, 6, 0}
clear_props()

-- A thing gets the speed that the impulse gives its mass, and at most 8 m/s.
for _, mass in ipairs {100, 5} do
    me:place {-15, 0, 15}
    foe:place {15, 0, 15}
    local box = spawn {kind = "box", size = {0.6, 0.6, 0.6}, mass = mass, at = {-15, 0.3, 8}, friction = 0}
    wait(0.5)
    local c, b = shoot({-15, 0.3, 8}, 1.7)
    local speed = length(box:velocity())
    expect_near(speed, math.min(300 / mass, 8), 0.2, "speed from an impulse of 300 N s")
    clear_props()
    wait(0.3)
end

-- A shot at the wizard's own feet.
me:place {-15, 0, 15}
me:face(0, -84)
wait(0.3)
local health = me:health()
me:hold("fire")
wait(1.7)
me:release("fire")
burst = expect_event {kind = "burst", by = 1, within = 0.3}
local own, by = hurt_of(1, burst)
expect(own > 10 and own <= 21, "splash damage to the shooter")
expect_near(by, 1, 0, "the shooter caused this damage")
expect_near(me:health(), health - own, 1e-9)
local of_foe = 0
for _, hit in ipairs(events {kind = "blast_hit", subject = 2}) do of_foe = of_foe + hit.amount end
expect_near(deeds(1, "blast").damage, of_foe, 1e-9, "damage statistics count only the foe's losses")
tick()
expect(me:velocity().y > 1, "the burst throws the shooter up")
wait(1)
expect_near(#missiles(), 0, 0)
