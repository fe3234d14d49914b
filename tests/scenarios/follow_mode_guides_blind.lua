-- The follow mode lets the hand slide along the flow and holds it across. A bot that sees nothing slides round the core and
-- waits in the middle of its way; where it feels nothing, it waits too. tests/stability/orb_follow_test.cpp plays this with
-- other values of the first line: with forces for 30 seeds, and without.
local seed, percent, limit = 1, 100, 20
match {players = {"script", "script"}, seed = seed, forces = {percent, 100}}
local me = wizard(1)
me:place {-16.5, 0, 0}
me:face(90, 0)
wait(0.3)
me:scry(4)
local began = time()
local function told() return me:health() > 100 end
local function over() return told() or time() - began >= limit end

local function wait_at(place)
    me:hand_to(place, 0.1, over)
    for _ = 1, 1600 do
        if over() then return end
        me:steer(place, 0.1)
    end
end

-- Slides along the flow from a place for one round. Returns the middle of the way, or nil if the way leads out of the
-- reach of the hand, and whether it felt anything.
local function round(from)
    me:hand_to(from, 0.1, over)
    local way, home, turned, sum, count, felt = {x = 0.6, y = 0.64, z = 0.48}, me:hand(), 0, {0, 0, 0}, 0, 0
    for i = 1, 3000 do
        local force = me:force()
        felt = felt + length(force)
        if i == 250 and felt < 1 then return nil, false end
        force = plus(force, way, -dot(force, way))
        local new = unit(plus(way, force, 0.05))
        if i > 250 then
            turned = turned + math.acos(math.max(-1, math.min(1, dot(way, new))))
            sum, count = plus(sum, me:hand()), count + 1
        end
        way = new
        home = plus(plus(home, way, 1e-4), force, 1.6e-4)
        if length(home) > 0.058 or math.abs(home.z) > 0.034 or over() then return nil, true end
        me:steer(home, 0.3)
        if turned > 2 * math.pi then return plus({0, 0, 0}, sum, 1 / count), true end
    end
    return nil, true
end

-- The middle of a round beside the last middle is nearer to the core.
local function search(from)
    local middle, felt = round(from)
    for _ = 1, 3 do
        local better = middle and round(plus(middle, {0.006, 0.006, 0.003}))
        if not better or over() then break end
        local moved = distance(better, middle)
        middle = better
        if moved < 0.004 then break end
    end
    if middle or not felt then wait_at(middle or from) end
end

local starts = {
    {0, 0, 0}, {0.022, 0, 0}, {-0.022, 0, 0}, {0, 0.022, 0}, {0, -0.022, 0}, {0, 0, 0.022}, {0, 0, -0.022},
    {0.015, 0.015, 0.015}, {-0.015, 0.015, 0.015}, {0.015, -0.015, 0.015}, {0.015, 0.015, -0.015}, {-0.03, 0.03, 0},
    {0.03, -0.03, 0}, {0.015, 0, 0}, {-0.015, 0, 0}, {0, 0.015, 0}, {0, -0.015, 0}, {0.03, 0.03, 0}, {-0.03, -0.03, 0},
}
for _, share in ipairs {1, 0.7, 1.4} do
    for _, from in ipairs(starts) do
        if not over() then search(plus({0, 0, 0}, from, share)) end
    end
end
log(string.format("%s after %.3f s", told() and "found" or "not found", time() - began))
expect(told() or limit ~= 20, "the bot found the core by force alone")
