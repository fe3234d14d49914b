-- With the paper's rules a wand regains energy only from a power-up, and a respawned wizard has no shield.
match {rules = "classic", players = {"script", "script"}}
trace("energy", {"1.energy"})
local me, foe = wizard(1), wizard(2)
clear_props()
me:place {-11.5, 0, 4}
me:face(0, 40)
me:hold("fire")
wait(8)
me:release("fire")
expect_near(me:shots(), 40, 0, "shots from an energy of 60")
expect_near(me:energy(), 0, 0)
wait(20)
expect_near(me:energy(), 0, 0, "energy does not come back by itself")
me:press("fire")
expect_event {kind = "dry", subject = 1, within = 0.1}
expect_near(me:shots(), 40, 0)
me:move(0, 1)
expect_event {kind = "power_up", subject = 1, within = 3}
me:stop()
expect_near(me:energy(), 30, 0, "energy from the spark")

foe:place {-14, 70, -9}
expect_event {kind = "spawn", subject = 2, within = 10}
tick()
expect(not foe:shielded(), "no shield after a return to life")
