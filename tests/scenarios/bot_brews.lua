-- A bot of level 3 that sees nobody brews a potion: it fetches the ingredients, stirs, drops them in at their moment and
-- draws the gestures, all by its own hand.
match {players = {"script", "bot 3"}, seed = 5, set = {"cauldron.brew.cells_across=12"}}
clear_props()
-- The foe is shut in behind two stones, where the bot does not see it.
spawn {kind = "box", size = {0.5, 4, 4}, mass = 9000, at = {16.4, 2, 18}, friction = 2}
spawn {kind = "box", size = {3.3, 4, 0.5}, mass = 9000, at = {18.3, 2, 16.2}, friction = 2}
wizard(1):place {18.5, 0, 18.5}
local made = expect_event {kind = "potion", by = 2, within = 60}
expect(#events {kind = "dropped", by = 2} == 2, "it has dropped two ingredients in")
local steps = events {kind = "brew_step", by = 2}
expect(#steps >= 3, "and done the steps of the recipe")
expect(made.time - steps[1].time < 20, "before the brew boils over")
expect(#events {kind = "brew_fault", by = 2} == 0, "without a wrong step")
