-- Ember is red and resin is green. Dropped in on both sides, each shows its own colour. Stirred, the whole
-- brew is yellow. The base is dark here, so that all colour comes from the ingredients.
match {players = {"script", "script"}, set = {"haptics.share=1", "cauldron.brew.colour=[0.05, 0.05, 0.05]", "cauldron.brew.cells_across=16",
    "cauldron.brewing.drop_m3=1.6", "cauldron.brewing.drop_radius_m=0.6", "cauldron.brewing.spoils_after_s=600"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
me:drop_in({-4.5, 0, 0}, {-2.2, 0, 0})
me:draw(-6, 0, 0.05)
me:release("stir")
wait(0.1)
me:drop_in({7, 0, 0}, {-2.2, 0, 0})
local apart = picture {name = "apart"}
local r, g, b = apart:mean(0.30, 0.58, 0.34, 0.62)
expect(r > 2 * g and r > 2 * b, string.format("red: %g, %g, %g", r, g, b))
r, g, b = apart:mean(0.08, 0.58, 0.11, 0.62)
expect(g > 1.1 * r and g > 1.5 * b, string.format("green: %g, %g, %g", r, g, b))
me:circles(14, 0.8, 4)
local together = picture {name = "together"}
for x = 0.1, 0.4, 0.06 do
    r, g, b = together:mean(x, 0.53, x + 0.05, 0.6)
    expect(math.abs(r - g) < 0.2 * g and b < 0.7 * g, string.format("yellow at %g: %g, %g, %g", x, r, g, b))
end
