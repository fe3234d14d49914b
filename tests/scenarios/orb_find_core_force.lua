-- The force mode: the flow carries the hand round the core, which lies in the middle of a round.
match {players = {"script", "script"}, seed = 4}
local me = wizard(1)
me:place {-16.5, 0, 0}
me:face(90, 0)
wait(0.3)
me:scry(3)
local function told() return me:health() > 100 end

local function wait_at(place)
    me:hand_to(place, 0.1, told)
    for _ = 1, 1600 do
        if told() then return end
        me:steer(place, 0.1)
    end
end

local function beyond(place) return length(place) > 0.058 or math.abs(place.z) > 0.033 end

-- Lets the push of the flow carry the hand from a place for one round. Returns the middle of the way, or nil if the way leads out of the
-- reach of the hand.
local function round(from)
    me:hand_to(from, 0.1, told)
    local way, home, turned, sum, count = {x = 0.6, y = 0.64, z = 0.48}, me:hand(), 0, {0, 0, 0}, 0
    for i = 1, 3000 do
        local new = unit(me:force())
        home = plus(home, new, 6e-5)
        if i > 250 then
            turned = turned + math.acos(math.max(-1, math.min(1, dot(way, new))))
            sum, count = plus(sum, me:hand()), count + 1
        end
        way = new
        if beyond(home) or told() then return nil end
        me:steer(home, 0.3)
        if turned > 2 * math.pi then return plus({0, 0, 0}, sum, 1 / count) end
    end
end

-- The middle of a round beside the last middle is nearer to the core.
local function search(from)
    local middle = round(from)
    for _ = 1, 3 do
        local better = middle and round(plus(middle, {0.006, 0.006, 0.003}))
        if not better or told() then break end
        local moved = distance(better, middle)
        middle = better
        if moved < 0.004 then break end
    end
    if middle then wait_at(middle) end
end

local far = 0.022
for _, from in ipairs {
    {0, 0, 0}, {far, 0, 0}, {-far, 0, 0}, {0, far, 0}, {0, -far, 0}, {0, 0, far}, {0, 0, -far}, {0.015, 0.015, 0.015},
    {-0.015, 0.015, 0.015}, {0.015, -0.015, 0.015}, {0.015, 0.015, -0.015},
} do
    if not told() then search(from) end
end
expect(told(), "the push of the flow led the hand to the core")
expect_event {kind = "scried", subject = 1}
expect_event {kind = "recipe_told", subject = 1}
