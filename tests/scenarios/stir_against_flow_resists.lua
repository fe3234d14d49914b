-- Stirring against the current takes more force than stirring with it.
match {players = {"script", "script"}, set = {"haptics.share=1"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
me:place {-2.2, 0, 0}
me:hold("stir")
wait(0.3)
trace("against", {"1.force_x", "1.force_y", "1.force_z"})
-- Stirs one circle and returns the mean force of its first quarter.
local function felt(sense)
    local sum = 0
    me:circles(1, 1, 2, sense, function(i) if i <= 250 then sum = sum + length(me:force()) end end)
    return sum / 250
end
me:draw(0, -2, 0.16)
wait(0.3)
me:circles(4, 1, 2)
local with = felt(1)
local against = felt(-1)
expect(against > 1.2 * with, string.format("with it %.3f N, against it %.3f N", with, against))
