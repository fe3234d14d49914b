-- Stirring in circles makes the brew turn that way, and the current carries a hand that lets go. The other
-- direction carries it the other way. A stronger current carries it with more force.
match {players = {"script", "script"}, set = {"haptics.share=1"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
me:place {-2.2, 0, 0}
trace("swirl", {"1.hand_x", "1.hand_y", "1.hand_z", "1.force_x", "1.force_y", "1.force_z"})

-- Swirl of the whole brew about its middle, as the speed half way out (m/s). Positive from +z to +x.
local function turning()
    local m, sum = brew().middle, 0
    for i = 0, 7 do
        local a = i * math.pi / 4
        local u = current {m.x + 0.65 * math.cos(a), m.y - 0.25, m.z + 0.65 * math.sin(a)}
        sum = sum + u.x * math.sin(a) - u.z * math.cos(a)
    end
    return sum / 8
end

-- Lets the hand go. Returns the distance that the current carries the device's tip in 0.4 s (m), and the
-- largest force on the way.
local function drift()
    local from, most = me:hand(), 0
    me:hold("clutch")
    for _ = 1, 400 do
        tick()
        most = math.max(most, length(me:force()))
    end
    me:release("clutch")
    local to = me:hand()
    return {x = to.x - from.x, z = to.z - from.z}, most
end

me:hold("stir")
wait(0.3)
expect(me:stirs())
me:draw(0, -2, 0.16)  -- the circles then go around the hand's place of rest
wait(0.3)

-- Whole circles, so that the hand is always let go at the same place.
local function run(seconds, sense, counts)
    me:circles(seconds, 1, counts, sense)
    local swirl = turning()
    local way, force = drift()
    return swirl, way, force
end

local swirl, way, force = run(2, 1, 1.5)
expect(math.abs(swirl) > 0.1, "speed of the swirl: " .. swirl)
picture {name = "swirl"}
local strong, strong_way, strong_force = run(3, 1, 2)
expect(strong / swirl > 1.3, "stronger stirring gives a faster swirl")
expect(strong_force > force, string.format("and so the current pulls harder: %.3f N, %.3f N", strong_force, force))
expect(length {strong_way.x, 0, strong_way.z} > 0.03 * 0.4, "the swirl carries the hand at 30 mm/s or more")
local back = run(6, -1, 2)
expect(back * strong < 0, "stirring the other way reverses the swirl")
local _, back_way = run(1, -1, 2)
expect(back_way.x * strong_way.x + back_way.z * strong_way.z < 0, "the reversed swirl carries the hand the other way")
expect(me:created() <= 0.02, "passive forces create no energy")
