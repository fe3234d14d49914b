-- Six draws of the sling, from short to full. The stone leaves at 6 to 22 m/s, depending on the draw of the
-- device, and lands where a thrown stone does. The hand feels a spring of 50 N/m with detents at 25, 50 and
-- 75 %, and at most 45 % of 3.3 N.
match {players = {"script", "script"}, set = {"lob.energy.cost=2"}}
trace("draw", {"1.force_y", "1.force_z", "1.hand_y", "1.hand_z", "1.readiness"})

local me = wizard(1)
local full, stiffness, cap, gravity = 0.055, 50, 0.45 * 3.3, 9.81
local n = math.sqrt(0.86 * 0.86 + 0.51 * 0.51)
local axis = {y = -0.86 / n, z = 0.51 / n}
local quantum = 5.5e-5
clear_props()  -- one of the tables is in the way
me:place {-15, 0, 17}
me:face(0, 12)
wizard(2):place {15, 0, 15}
me:press("wand_3")
wait(0.5)

local function along(v) return v.y * axis.y + v.z * axis.z end

local function detent(s)
    local force = 0
    for i = 1, 3 do
        local off = (s - i * full / 4) / 0.008
        if math.abs(off) < 0.5 then force = force - 0.3 * math.sin(2 * math.pi * off) end
    end
    return force
end

local errors = {}
for i = 1, 6 do
    me:trigger(i / 6)
    local anchor = me:hand()  -- dry friction holds the hand where it has stopped
    local function stretch()
        local hand = me:hand()
        return along {y = hand.y - anchor.y, z = hand.z - anchor.z}
    end
    me:hold("fire")
    local before = 0
    for _ = 1, 1100 do
        tick()
        expect(me:readiness() >= before - 2e-3, "the hand is drawn back")
        before = me:readiness()
    end
    -- At rest the hand feels the spring with its detents, up to the force limit.
    local s = stretch()
    local felt, pull = along(me:force()), stiffness * s - detent(s)
    expect_near(-felt, math.min(pull, cap), 0.03, "force of the spring " .. i)
    expect_near(me:readiness(), math.min(s / full, 1), 2 * quantum / full, "draw measured at the device")

    local share = me:readiness()
    me:release("fire")
    local shot = expect_event {kind = "shot", by = 1, within = 0.02}
    local stone = nil
    wait_until(function() stone = missiles()[1] return stone ~= nil end, 0.1)
    local from, speed, pitch = shot.place, 6 + 16 * share, me:pitch()

    -- The stone touches the ground with its radius of 0.1 m. Before that it is on the parabola.
    local vx, vy = speed * math.cos(pitch), speed * math.sin(pitch)
    local drop = from.y - 0.1
    local flight = (vy + math.sqrt(vy * vy + 2 * gravity * drop)) / gravity
    local range = vx * flight
    local last = nil
    wait_until(function()
        stone = missiles()[1]
        if stone.velocity.y > 0 and last and last.velocity.y < 0 then return true end
        last = stone
        return false
    end, 1.7)
    local landed = last.position
    local flown = math.sqrt((landed.x - from.x) * (landed.x - from.x) + (landed.z - from.z) * (landed.z - from.z))
    -- The last tick before the ground is within one step of the landing.
    local at_ground = flown + math.max(0, landed.y - 0.1) * vx / -last.velocity.y
    errors[i] = at_ground / range - 1
    log(string.format("draw %.1f mm  speed %.3f m/s  range %.4f m  closed form %.4f m  error %.5f %%",
                      1000 * share * full, speed, at_ground, range, 100 * errors[i]))
    expect_near(at_ground, range, 0.03 * range, "range " .. i)
    expect_near(at_ground, range, 0.002 * range, "range is much closer than required")
    if i == 6 then expect_near(share, 1, 0, "a key draws the sling fully") end
    wait(2)
end

-- For a throw that returns to its starting height, the range is v^2 sin 2a / g.
expect_near(me:shots(), 6, 0)
expect_near(me:energy(), 48 - 12, 1e-9)

-- Too short a draw fires no shot and costs no energy.
me:trigger(0.05)
me:press("fire", 0.5)
wait(0.1)
expect_near(me:shots(), 6, 0)
expect_near(me:energy(), 36, 1e-9)
expect_near(#missiles(), 0, 0)

-- With another wand in hand the sling lets go, no shot is fired, and the hand is free.
me:trigger(1)
me:hold("fire")
wait(1)
expect(me:readiness() > 0.9, "the sling is drawn")
me:press("wand_2")
me:release("fire")
wait(0.5)
expect_near(me:shots(), 6, 0)
expect_near(length(me:force()), 0, 0, "no force on the hand after the wand was changed")
expect(length(me:hand()) < 0.002, "the hand returns to its rest")
