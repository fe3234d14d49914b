-- A brew that its owner keeps well mixed for five seconds heals that owner near the bowl, once: 1 HP a second for ten
-- seconds. Far from the bowl it does not, and a brew that the foe has wrested begins anew.
match {players = {"script", "script"}, set = {"cauldron.brew.cells_across=16", "cauldron.brewing.spoils_after_s=600",
    "cauldron.boon.mixed=0.5"}}
clear_props()
local me, foe = wizard(1), wizard(2)
me:place {-8, 0, 8}
foe:place {-8, 0, 14}
foe:aim(me)
foe:hold("fire")
while me:health() > 45 do wait(0.05) end
foe:release("fire")
wait(1)
foe:place {15, 0, -15}
me:drop_in({-4.5, 0, 0}, {-2.2, 0, 0})
me:circles(10, 0.8, 4)
expect(brew().mixing >= 0.5, "the brew is well mixed: " .. brew().mixing)
local healed = expect_event {kind = "boon", by = 1, within = 6}
expect_near(healed.amount, 10, 1e-9, "health that the boon can give")
local before = me:health()
wait(4)
expect_near(me:health(), before + 4, 0.1, "one point of health a second")
me:release("stir")
me:place {12, 0, 12}
wait(0.1)
before = me:health()
wait(2)
expect(me:health() == before, "no healing far from the bowl")
me:place {-2.2, 0, 0}
wait(6)
before = me:health()
wait(6)
expect(me:health() == before, "the boon is over, and the brew gives no second one")
