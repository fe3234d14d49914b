-- A lob's burst costs a touched wizard 60 HP, evenly less to nothing at 4 m, and nothing behind a wall. The
-- lob bursts on a wizard or 1.8 s after the throw. It bounces and passes through no wall.
match {players = {"script", "script"}, set = {"wizard.health.start=1000", "wizard.health.cap=1000", "lob.energy.cap=480"}}
trace("health", {"1.health", "2.health", "2.speed", "1.force_y", "1.force_z"})
local me, foe = wizard(1), wizard(2)
local stone, radius, half_axis = 0.1, 0.35, 0.55
clear_props()
me:press("wand_3")

local function gap(centre, place)
    local y = math.max(centre.y - half_axis, math.min(centre.y + half_axis, place.y))
    return math.max(0, distance(place, {centre.x, y, centre.z}) - radius - stone)
end

local function hurt_of(who, burst)
    for _, hit in ipairs(events {kind = "lob_hit", subject = who}) do
        if hit.time == burst.time then return hit.amount, hit.by end
    end
    return 0
end

local function throw(share, seconds)
    me:trigger(share)
    me:hold("fire")
    wait(seconds or 1)
    if share == 1 then expect_near(length(me:force()), 0.45 * 3.3, 1e-9, "force limit at a full draw") end
    me:release("fire")
    return expect_event {kind = "shot", by = 1, within = 0.02}
end

-- A lob that hits the foe bursts at once with its full harm.
me:place {-15, 0, 15}
foe:place {-15, 0, 10}
me:aim(foe)
wait(0.3)
local shot = throw(1)
local burst = expect_event {kind = "burst", by = 1, within = 1}
expect(burst.time - shot.time < 0.4, "the stone bursts before its fuse ends")
local amount, by = hurt_of(2, burst)
expect_near(amount, 60, 0.01, "damage to the touched wizard")
expect_near(by, 1, 0)
tick()  -- the push moves bodies in the next tick
expect_near(length(foe:velocity()), 250 / 75, 0.1, "the burst pushes the wizard")
wait(1)

-- A lob bounces off a wall of a centimetre. At the end of its fuse the harm depends on the distance.
local seen = {}
for i, off in ipairs {0.6, 1.2, 2, 3, 4, 5} do
    foe:place {15, 0, 15}
    me:place {-15, 0, 18}
    me:face(0, 0)
    wait(0.3)
    shot = throw(0.4)
    wait(1.5)
    local rests = missiles()[1]
    expect(length(rests.velocity) < 0.1, "the stone comes to rest")
    expect_near(rests.position.y, stone, 0.002, "the stone lies on the ground")
    foe:place {rests.position.x + off, 0, rests.position.z}
    local centre = foe:centre()
    burst = expect_event {kind = "burst", by = 1, within = 0.5}
    expect_near(burst.time - shot.time, 1.8, 0.002, "time of the fuse")
    expect_near(burst.amount, 4, 0)
    local d = gap(centre, burst.place)
    amount = hurt_of(2, burst)
    expect_near(amount, 60 * math.max(0, 1 - d / 4), 0.5, "damage falls with distance " .. i)
    seen[i] = amount
    expect(i == 1 or amount <= seen[i - 1])
    wait(0.3)
end
expect(seen[1] > 45 and seen[5] > 0 and seen[6] == 0, "damage falls from most of it to nothing")

-- A wizard behind a wall is not hurt.
me:place {-15, 0, 18}
me:face(0, 0)
foe:place {15, 0, 15}
wait(0.3)
throw(0.4)
wait(1.5)
local rests = missiles()[1].position
spawn {kind = "box", size = {0.05, 2.5, 4}, mass = 9000, at = {rests.x + 0.5, 1.26, rests.z}, friction = 2}
foe:place {rests.x + 1.2, 0, rests.z}
burst = expect_event {kind = "burst", by = 1, within = 0.5}
expect_near(hurt_of(2, burst), 0, 0, "a wall shields from the burst")
clear_props()

-- The lob does not pass through the wall, although it is fast and the wall is thin.
me:place {-15, 0, 15}
foe:place {15, 0, 15}
me:face(0, 0)
local thin = spawn {kind = "box", size = {4, 3, 0.02}, mass = 9000, at = {-15, 1.52, 9}, friction = 2}
wait(0.3)
throw(1)
local farthest = 99
for _ = 1, 1700 do
    tick()
    local m = missiles()[1]
    if m then farthest = math.min(farthest, m.position.z) end
end
expect(farthest > 9.1, "the stone bounces back from the wall")
expect(farthest < 9.3, "the stone reaches the wall")
clear_props()
wait(1)

-- The thrower is hurt as well, credited to the thrower. The distant foe is not hurt.
me:place {-15, 0, 15}
me:face(0, -80)
wait(0.3)
local health = me:health()
throw(0.3, 0.6)
burst = expect_event {kind = "burst", by = 1, within = 2}
amount, by = hurt_of(1, burst)
expect(amount > 20 and amount <= 60, "damage to the thrower")
expect_near(by, 1, 0)
expect_near(me:health(), health - amount, 1e-9)
expect_near(hurt_of(2, burst), 0, 0)
wait(0.5)
expect_near(#missiles(), 0, 0)
