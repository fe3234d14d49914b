-- The follow mode: the hand slides along the flow and is held across it, so its way leads round the core.
match {players = {"script", "script"}, seed = 3}
local s = seeker(1, 4)

local function slide(way, home)
    local across = s.wizard:force()
    across = plus(across, way, -dot(across, way))
    local new = unit(plus(way, across, 0.05))
    return new, plus(plus(home, new, 1e-4), across, 1.6e-4)
end

s:from_everywhere(function(from) s:by_rounds(from, slide) end)
s:expect_found("the way along the flow led the hand to the core")
