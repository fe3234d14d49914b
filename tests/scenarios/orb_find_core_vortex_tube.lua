-- The vortex tube mode holds ways out of a vortex. What is felt while the hand moves about points to the core.
match {players = {"script", "script"}, seed = 4}
local me = wizard(1)
me:place {-16.5, 0, 0}
me:face(90, 0)
wait(0.3)
me:scry(5)
local function told() return me:health() > 100 end

local function wait_at(place)
    me:hand_to(place, 0.1, told)
    for _ = 1, 1600 do
        if told() then return end
        me:steer(place, 0.1)
    end
end

local function beyond(place) return length(place) > 0.058 or math.abs(place.z) > 0.033 end

-- The mean force while the hand moves about a place.
local function feel(at)
    local sum = {0, 0, 0}
    for i = 1, 240 do
        local a, b, r = math.pi * i / 60, math.pi * i / 40, 0.003
        me:steer(plus(at, {r * math.cos(a), r * math.sin(a), r * math.sin(b)}), 0.5)
        if i > 40 then sum = plus(sum, me:force()) end
    end
    return plus({0, 0, 0}, sum, 1 / 200)
end

local function search(from)
    me:hand_to(from, 0.1, told)
    local at, most = {x = from[1], y = from[2], z = from[3]}, 0
    for i = 1, 12 do
        local force = feel(at)
        local size = length(force)
        if i == 1 and size < 0.03 then return end
        most = math.max(most, size)
        at = plus(at, force, 0.004 / math.max(0.1, most))
        if beyond(at) or told() or size < 0.03 then break end
    end
    if not beyond(at) then wait_at(at) end
end

local far = 0.022
for _, from in ipairs {
    {0, 0, 0}, {far, 0, 0}, {-far, 0, 0}, {0, far, 0}, {0, -far, 0}, {0, 0, far}, {0, 0, -far}, {0.015, 0.015, 0.015},
    {-0.015, 0.015, 0.015}, {0.015, -0.015, 0.015}, {0.015, 0.015, -0.015},
} do
    if not told() then search(from) end
end
expect(told(), "the walls of the vortex led the hand to the core")
expect_event {kind = "scried", subject = 1}
expect_event {kind = "recipe_told", subject = 1}
