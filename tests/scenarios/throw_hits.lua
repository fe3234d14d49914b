-- A thrown thing goes where the crosshair is, as fast as 16 m/s or as the energy allows (0.05 for 1 N s), and its blow is the thrower's deed.
match {players = {"script", "script"}}
clear_props()
local me, foe = wizard(1), wizard(2)
me:place {4, 0, 16}
me:face(-90, 0)
foe:place {13, 0, 16}
local thing = spawn {kind = "sphere", radius = 0.3, mass = 20, at = {7, 0.3, 16}}
trace("throw", {"1.energy", "1.force_z", "2.health", "t1.x", "t1.y", "t1.speed"})
wait(0.3)
me:press("wand_4")
me:aim(thing)
wait(0.1)
me:hold("fire")
wait(0.1)
me:look(0, 12)
wait(1.5)
me:aim(foe)
wait(1)
local energy = me:energy()
local impulse, speed = 0, nil
me:hold("throw")
for i = 1, 100 do
    tick()
    impulse = impulse + me:force().z * 0.001
    if not speed and thing:velocity().x > 15 then speed = length(thing:velocity()) end
end
me:release("throw")
expect_near(speed, 16, 0.1, "16 m/s")
expect_near(impulse, 2 / math.pi * 2 * 0.45 * 0.04, 0.05 * impulse, "the recoil: half a sine of 2 N in 40 ms, of which 45 % are felt")
me:release("fire")
expect_near(energy - me:energy(), 0.05 * 20 * 16, 1.5, "0.05 for 1 N s")
expect_event {kind = "object_hit", subject = 2, by = 1, within = 1.5}
expect(foe:health() < 90, "that hurt")
expect_near(deeds(1, "blow").hits, 1, 0, "it is the thrower's deed")

-- With little energy left it goes slower: what is left pays for it.
thing:place {7, 0.3, 12.8}
foe:place {-13, 0, 16}
wait(0.5)
me:aim(thing)
wait(0.2)
me:hold("fire")
wait(0.2)
expect(me:energy() < 75 and me:energy() > 20)
me:look(0, 12)
wait_until(function() return me:energy() < 8 end, 20)
local left = me:energy()
me:press("throw")
wait_until(function() return length(thing:velocity()) > 3 end, 0.1)
expect_near(length(thing:velocity()), left / (0.05 * 20), 0.6, "all that is left")
me:release("fire")
wait(0.2)
expect(me:energy() < 0.7, "and now there is none")
