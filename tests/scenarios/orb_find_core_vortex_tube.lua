-- The vortex tube mode resists ways out of a vortex. The forces that are felt while the hand moves about
-- point to the core.
match {players = {"script", "script"}, seed = 4}
local s = seeker(1, 5)

local function search(from)
    s:go(from)
    local at, most = {x = from[1], y = from[2], z = from[3]}, 0
    for i = 1, 12 do
        local force = s:feel(at, 0.003)
        local size = length(force)
        if i == 1 and size < 0.03 then return end
        most = math.max(most, size)
        at = plus(at, force, 0.004 / math.max(0.1, most))
        if s:beyond(at) or s:told() or size < 0.03 then break end
    end
    if not s:beyond(at) then s:wait_at(at) end
end

s:from_everywhere(search)
s:expect_found("the walls of the vortex led the hand to the core")
