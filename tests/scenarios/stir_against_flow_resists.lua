-- Against the current the hand is held harder than with it.
match {players = {"script", "script"}, set = {"haptics.share=1"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
me:place {-2.2, 0, 0}
me:hold("stir")
wait(0.3)
trace("against", {"1.force_x", "1.force_y", "1.force_z"})
-- The mean force of the first quarter of a second.
local function circles(seconds, sense)
    local sum = 0
    for i = 1, seconds * 1000 do
        local a = 2 * math.pi * i / 1000
        me:stroke(math.floor(sense * 2 * math.cos(a) + 0.5), math.floor(2 * math.sin(a) + 0.5))
        tick()
        if i <= 250 then sum = sum + length(me:force()) end
    end
    return sum / 250
end
me:draw(0, -2, 0.16)
wait(0.3)
circles(4, 1)
local with = circles(1, 1)
local against = circles(1, -1)
expect(against > 1.2 * with, string.format("with it %.3f N, against it %.3f N", with, against))
