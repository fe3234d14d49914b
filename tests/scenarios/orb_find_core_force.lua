-- The force mode: the flow carries the hand round the core, which lies in the middle of a round.
match {players = {"script", "script"}, seed = 4}
local s = seeker(1, 3)

local function let_go(_, home)
    local push = unit(s.wizard:force())
    return push, plus(home, push, 6e-5)
end

s:from_everywhere(function(from) s:by_rounds(from, let_go) end)
s:expect_found("the push of the flow led the hand to the core")
