-- The surface mode resists ways to slower places. The core lies against the forces that are felt while the
-- hand moves about.
match {players = {"script", "script"}, seed = 2}
local s = seeker(1, 6)

local function until_it_turns(from, sign, most)
    s:go(from)
    local at, way = from, nil
    for _ = 1, most do
        local force = unit(s:feel(at, 0.0025))
        if way and dot(force, way) < 0 then return at, unit(way) end
        way = way and plus(way, force) or force
        at = plus(at, force, sign * 0.003)
        if s:beyond(at) or s:told() then return nil end
    end
end

s:from_everywhere(function(from) s:behind_ring(from, until_it_turns, 20, 9) end)
s:expect_found("the surfaces of the flow led the hand to the core")
