-- Faders that a player moves during the match are input of that tick: the hand feels the new share from then on, the
-- force fades over instead of jumping, and the match comes out the same after a seek.
match {players = {"script", "script"}, set = {"haptics.share=1"}}
trace("force", {"1.force_y", "1.force_z", "2.force_z"})
clear_props()
local me, foe = wizard(1), wizard(2)
local mass = 30
me:place {8, 0, 16}
me:face(-90, 0)
foe:place {18, 0, -16}
local thing = spawn {kind = "box", size = {1, 1, 1}, mass = mass, at = {11, 0.5, 16}}
wait(0.3)
me:press("wand_4")
me:aim(thing)
wait(0.1)
me:hold("fire")
wait(0.1)
me:look(0, 15)
wait(2)
local whole = me:force().y
expect_near(whole, -0.01 * mass, 0.015, "the whole weight is felt at first")

-- The weight's fader. The change fades by at most 40 N/s, so 0.04 N in a tick.
local function steepest(seconds)
    local before, most = me:force(), 0
    for _ = 1, seconds * 1000 do
        tick()
        local now = me:force()
        most = math.max(most, length {now.x - before.x, now.y - before.y, now.z - before.z})
        before = now
    end
    return most
end
me:fader("weight", 50)
expect(steepest(0.5) < 0.05, "the weight fades over")
expect_near(me:force().y, -0.005 * mass, 0.015, "half the weight is felt")
me:fader("weight", 0)
expect(steepest(0.5) < 0.05, "the weight fades away")
expect_near(me:force().y, 0, 0.015, "no weight is felt")
me:fader("weight", 100)
wait(0.5)
expect_near(me:force().y, whole, 0.01, "the whole weight is back")

-- The fader of the largest force, in hundredths of 3.3 N. At 0 there are no forces at all.
me:fader("force", 5)
wait(0.5)
expect(length(me:force()) <= 0.05 * 3.3 + 1e-9, "a twentieth of the device's force at most: " .. length(me:force()))
me:fader("force", 0)
expect(steepest(0.06) < 0.05, "the force fades away in 50 ms")
expect(length(me:force()) == 0, "no force")
wait(0.2)
me:fader("force", 100)
wait(1)
expect_near(me:force().y, whole, 0.02, "the force is back")
me:release("fire")
wait(0.5)

-- The recoil's fader: each player has one of their own.
local function kick_of(one)
    one:face(0, 0)
    one:press("wand_1")
    wait(0.3)
    local most = 0
    one:hold("fire")
    for _ = 1, 60 do
        tick()
        most = math.max(most, one:force().z)
    end
    one:release("fire")
    wait(0.3)
    return most
end
local all = kick_of(me)
expect(all > 0.8, "kick of a bolt: " .. all)
me:fader("recoil", 25)
expect_near(kick_of(me), 0.25 * all, 0.03, "a quarter of the kick")
expect_near(kick_of(foe), all, 0.03, "the foe's kick is whole")
me:fader("recoil", 0)
expect(kick_of(me) < 0.01, "no kick")
