-- The gradient mode pushes to where the flow is fast: a ring round the core. From the ring, the way against
-- the push leads to the core.
match {players = {"script", "script"}, seed = 5}
local s = seeker(1, 2)

local function until_it_turns(from, sign, most)
    s:go(from)
    local home, way = from, nil
    for i = 1, most do
        local push = unit(s.wizard:force())
        if i > 60 then
            if way and dot(push, way) < 0 then return home, unit(way) end
            way = way and plus(plus({0, 0, 0}, way, 0.97), push, 0.03) or push
            home = plus(home, push, sign * 4e-5)
            if s:beyond(home) or s:told() then return nil end
        end
        s.wizard:steer(home, 0.3)
    end
end

s:from_everywhere(function(from) s:behind_ring(from, until_it_turns, 1500, 700) end)
s:expect_found("the push to fast places led the hand to the core")
