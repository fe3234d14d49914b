-- The weight of the brew is tuned by three figures. Three gentle circles in 3 s speed it up to 0.5 m/s. Brisk
-- stirring for 6 s mixes two substances to 0.5. The current then carries a relaxed hand at 30 mm/s (device).
match {players = {"script", "script"}, set = {"haptics.share=1"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
local hardest = 0
-- Moves back, so that the circles go around the hand's place of rest. A circle begins at its near end.
local function back(counts, period)
    local metres = 1e-4 * counts * 1000 * period / (2 * math.pi)
    me:draw(0, -2, metres / 1e-4 / 2 / 1000)
    wait(0.3)
end
local function note_force() hardest = math.max(hardest, length(me:force())) end
trace("brew", {"1.force_x", "1.force_y", "1.force_z"})
me:drop_in({-4.5, 0, 0}, {-2.2, 0, 0})
me:release("stir")
wait(0.1)
me:drop_in({4.5, 0, 0}, {-2.2, 0, 0})
wait(0.2)
back(2, 1)
hardest = 0
me:circles(3, 1, 2, 1, note_force)
expect(brew().speed >= 0.5, "speed of the brew after three gentle circles: " .. brew().speed)
expect(hardest <= 1, "gentle: " .. hardest .. " N")
me:circles(6, 0.8, 4)
expect(brew().mixing >= 0.5, "mixing of the brew: " .. brew().mixing)
local from = me:hand()
me:hold("clutch")
wait(0.4)
local to = me:hand()
local speed = length {to.x - from.x, to.y - from.y, to.z - from.z} / 0.4
expect(speed >= 0.03, "carried: " .. 1000 * speed .. " mm/s")
