-- A thrown thing flies to the crosshair at 20 m/s, or slower if the energy is short (0.05 for 1 N s). Its
-- blow is credited to the thrower.
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
-- The kick is half a sine of 2 N in 40 ms, of which 45 % are felt. Switching the spring off leaves a step:
-- the force before minus the kick's first tick. The step fades at 40 N/s, and the kick itself is not delayed.
local function kick(i)
    local half = math.pi / 80
    return i < 40 and 0.45 * 2 * math.sin(half) / half * math.sin((2 * i + 1) * half) or 0
end
local function recoil(from)
    local offset = {from.x, from.y, from.z - kick(0)}
    local impulse, size = 0, length(offset)
    for i = 0, 60 do
        local left = math.max(0, size - 0.04 * (i + 1))
        impulse = impulse + (kick(i) + left * offset[3] / size) * 0.001
    end
    return impulse
end
local impulse, speed, expected, shots = 0, nil, nil, me:shots()
me:hold("throw")
for i = 1, 100 do
    tick()
    if expected then impulse = impulse + me:force().z * 0.001 end
    if not expected and me:shots() > shots then expected = recoil(me:force()) end
    if not speed and thing:velocity().x > 18 then speed = length(thing:velocity()) end
end
me:release("throw")
expect_near(speed, 20, 0.1, "speed of the throw")
expect_near(impulse, expected, 1e-9, "impulse of the recoil")
expect(impulse > 0.8 * 2 / math.pi * 2 * 0.45 * 0.04, "the recoil is most of a half sine")
me:release("fire")
expect_near(energy - me:energy(), 0.05 * 20 * 20, 1.5, "energy of 0.05 per N s")
expect_event {kind = "object_hit", subject = 2, by = 1, within = 1.5}
expect(foe:health() < 90, "the thrown thing hurts the foe")
expect_near(deeds(1, "blow").hits, 1, 0, "the thrower gets the hit")

-- With little energy left the throw is slower, as the energy allows.
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
expect_near(length(thing:velocity()), left / (0.05 * 20), 0.6, "speed that the remaining energy allows")
me:release("fire")
wait(0.2)
expect(me:energy() < 0.7, "no energy is left")
