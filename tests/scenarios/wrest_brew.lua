-- With both ladles in, the player with more work in the last 1.5 s gets the brew.
match {players = {"script", "script"}}
clear_props()
local one, two = wizard(1), wizard(2)
two:place {15, 0, -15}
one:place {-4.5, 0, 0}
wait(0.1)
one:place {-2.2, 0, 0}
two:place {2.2, 0, 0}
one:hold("stir") two:hold("stir")
wait(0.3)
one:press("fire")
wait(0.2)
expect(brew().owner == 1, "the player who dropped the ingredient owns the brew")
two:circles(2, 0.8, 3)
expect(brew().owner == 2, "the player who stirs harder owns the brew")
expect_event {kind = "wrested", by = 2, within = 0.1}
one:circles(3, 0.8, 3)
expect(brew().owner == 1, "stirring harder wins the brew back")
