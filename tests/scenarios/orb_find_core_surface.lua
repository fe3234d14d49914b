-- The surface mode holds ways to slower places. Against what is felt while the hand moves about, it is the way to the core.
match {players = {"script", "script"}, seed = 2}
local me = wizard(1)
me:place {-16.5, 0, 0}
me:face(90, 0)
wait(0.3)
me:scry(6)
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
        local a, b, r = math.pi * i / 60, math.pi * i / 40, 0.0025
        me:steer(plus(at, {r * math.cos(a), r * math.sin(a), r * math.sin(b)}), 0.5)
        if i > 40 then sum = plus(sum, me:force()) end
    end
    return plus({0, 0, 0}, sum, 1 / 200)
end

-- Goes with the force (sign 1) or against it (-1) until it turns round. Returns the place and the way there.
local function until_it_turns(from, sign, most)
    me:hand_to(from, 0.1, told)
    local at, way = from, nil
    for _ = 1, most do
        local force = unit(feel(at))
        if way and dot(force, way) < 0 then return at, unit(way) end
        way = way and plus(way, force) or force
        at = plus(at, force, sign * 0.003)
        if beyond(at) or told() then return nil end
    end
end

local function search(from)
    local ring, way = until_it_turns(from, 1, 20)
    for side = 1, ring and -1 or 2, -2 do
        local middle = not told() and until_it_turns(plus(ring, way, side * 0.006), -1, 9)
        if middle then wait_at(middle) end
    end
end

local far = 0.022
for _, from in ipairs {
    {0, 0, 0}, {far, 0, 0}, {-far, 0, 0}, {0, far, 0}, {0, -far, 0}, {0, 0, far}, {0, 0, -far}, {0.015, 0.015, 0.015},
    {-0.015, 0.015, 0.015}, {0.015, -0.015, 0.015}, {0.015, 0.015, -0.015},
} do
    if not told() then search(from) end
end
expect(told(), "the surfaces of the flow led the hand to the core")
expect_event {kind = "scried", subject = 1}
expect_event {kind = "recipe_told", subject = 1}
