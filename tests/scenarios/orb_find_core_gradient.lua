-- The gradient mode pushes to where the flow is fast: a ring round the core. Against the push it is the way to the middle.
match {players = {"script", "script"}, seed = 5}
local me = wizard(1)
me:place {-16.5, 0, 0}
me:face(90, 0)
wait(0.3)
me:scry(2)
local function told() return me:health() > 100 end

local function wait_at(place)
    me:hand_to(place, 0.1, told)
    for _ = 1, 1600 do
        if told() then return end
        me:steer(place, 0.1)
    end
end

local function beyond(place) return length(place) > 0.058 or math.abs(place.z) > 0.033 end

-- Goes with the push (sign 1) or against it (-1) until it turns round. Returns the place and the way there.
local function until_it_turns(from, sign, most)
    me:hand_to(from, 0.1, told)
    local home, way = from, nil
    for i = 1, most do
        local push = unit(me:force())
        if i > 60 then
            if way and dot(push, way) < 0 then return home, unit(way) end
            way = way and plus(plus({0, 0, 0}, way, 0.97), push, 0.03) or push
            home = plus(home, push, sign * 4e-5)
            if beyond(home) or told() then return nil end
        end
        me:steer(home, 0.3)
    end
end

local function search(from)
    local ring, way = until_it_turns(from, 1, 1500)
    for side = 1, ring and -1 or 2, -2 do
        local middle = not told() and until_it_turns(plus(ring, way, side * 0.006), -1, 700)
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
expect(told(), "the push to fast places led the hand to the core")
expect_event {kind = "scried", subject = 1}
expect_event {kind = "recipe_told", subject = 1}
