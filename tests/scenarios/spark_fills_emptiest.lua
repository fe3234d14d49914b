-- A spark fills half of the emptiest wand.
match {players = {"script", "script"}}
trace("energy", {"1.energy"})
local me = wizard(1)
me:place {-11.5, 0, 4}
me:face(0, 30)
me:hold("fire")
wait_until(function() return me:energy() < 20 end, 10)
me:release("fire")
me:move(0, 1)
wait_until(function() return distance(me:position(), {-11.5, 0, 0}) < 1 end, 3)
local before, at = me:energy(), time()
local taken = expect_event {kind = "power_up", subject = 1, within = 1}
me:stop()
expect_near(taken.detail, 2, 0, "kind of the power-up")
expect_near(taken.amount, 30, 0, "energy of half a wand")
expect_near(me:energy(), before + 30 + (time() - at), 0.02)
expect_near(me:health(), 100, 0, "a spark gives no health")

-- The spark returns after 15 s and fills no more than the wand holds.
wait(8)
me:press("fire", 1)
wait(5.9)
before = me:energy()
expect(before > 35 and before < 59)
local again = expect_event {kind = "power_up", subject = 1, within = 0.2}
expect_near(again.time - taken.time, 15, 0.008, "time until the spark is back")
expect_near(again.amount, 60 - before, 0.12, "energy up to the cap")
expect(me:energy() <= 60, "energy never exceeds the cap")
