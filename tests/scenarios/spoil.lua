-- Twenty seconds after the first ingredient the brew boils over. Wizards at the rim lose 10 HP and are
-- pushed, and the brew is pure again.
match {players = {"script", "script"}, set = {"cauldron.brew.cells_across=16"}}
clear_props()
local me, foe = wizard(1), wizard(2)
foe:place {-2.2, 0, 1.5}
me:drop_in({-4.5, 0, 0}, {-2.2, 0, 0})  -- ember
me:release("stir")
expect_event {kind = "dropped", by = 1, within = 0.1}
me:place {12, 0, 12}
expect(brew().owner == 1)
wait(19)
expect(#brew().contents == 1 and foe:health() == 100)
expect_event {kind = "boiled_over", within = 1.5}
expect_near(foe:health(), 90, 1e-9, "health of the wizard at the rim")
expect(me:health() == 100, "a distant wizard is not hurt")
wait(0.1)
expect(length(foe:velocity()) > 2, "the wizard at the rim is thrown back")
expect(#brew().contents == 0, "the brew is pure again")
expect(brew().owner == nil)
