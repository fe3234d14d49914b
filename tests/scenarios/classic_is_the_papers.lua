-- The paper's own solver on its own grid of 15 cells works in the match too. The brew can be stirred, and it
-- loses its momentum before the current has gone once around.
match {players = {"script", "script"}, set = {"haptics.share=1", "cauldron.brew.solver='classic'", "cauldron.brew.cells_across=15"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
me:place {-2.2, 0, 0}
me:hold("stir")
wait(0.3)
me:draw(0, -2, 0.16)
trace("classic", {"1.force_x", "1.force_y", "1.force_z"})
me:circles(3, 1, 2)
local stirred = brew().speed
expect(stirred > 0.05, "speed of the stirred brew: " .. stirred)
expect(length(me:force()) > 0.05, "the hand feels the stirring")
me:release("stir")
wait(3)
expect(brew().speed < 0.5 * stirred, string.format("%.3f m/s, three seconds later %.3f", stirred, brew().speed))
