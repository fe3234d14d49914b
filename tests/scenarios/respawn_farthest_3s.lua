-- A dead wizard returns after 3 s on the pad farthest from the foe. Nothing hurts the wizard for 1.5 s, or
-- until the wizard attacks.
match {match = "quick", set = {"quick.kills=1000"}, players = {"script", "script"}}
clear_props()
local me, foe = wizard(1), wizard(2)
local pads = {{-15, 0, 15}, {-15, 0, -15}, {15, 0, 15}, {15, 0, -15}}

local function fall(height)
    foe:place {-14, height, -9}
end

local function die()
    fall(70)
    local death = expect_event {kind = "death", subject = 2, within = 6}
    expect(foe:dead())
    expect_near(foe:health(), 0, 0)
    return death
end

-- Each time the killer stands elsewhere, so that another pad is the farthest one.
for _, place in ipairs {{10, 0, 14}, {-12, 0, 13}, {12, 0, -12}, {-10, 0, -14}} do
    me:place(place)
    local death = die()
    wait(2.9)
    expect(foe:dead(), "still dead after 2.9 s")
    local spawned = expect_event {kind = "spawn", subject = 2, within = 0.2}
    expect_near(spawned.time - death.time, 3, 0.008, "time from death to return")
    tick()
    local farthest = pads[1]
    for _, pad in ipairs(pads) do
        if distance(pad, me:position()) > distance(farthest, me:position()) then farthest = pad end
    end
    expect_near(distance(foe:position(), farthest), 0, 0.05, "distance from the farthest pad")
    expect_near(foe:health(), 100, 0, "full health after the return")
    expect_near(foe:energy(), 60, 0, "full energy after the return")
end

-- The shield: a landing at 12 m/s within 1.5 s costs nothing, and later 54 HP.
local high = 12 * 12 / (2 * 9.81)
expect(foe:shielded(), "shielded after the return")
fall(high)
wait(1.3)
expect(foe:grounded() and foe:shielded(), "landed while the shield lasts")
expect_near(foe:health(), 100, 0, "no harm while the shield lasts")
wait(0.3)
expect(not foe:shielded(), "the shield ends after 1.5 s")
fall(high)
wait(1.4)
expect_near(foe:health(), 100 - 12 * (12 - 7.5), 1, "harm after the shield has ended")

-- An attack ends the shield at once.
die()
expect_event {kind = "spawn", subject = 2, within = 3.2}
tick()
expect(foe:shielded())
foe:look(0, 30)
foe:press("fire")
expect_near(#events {kind = "shot", by = 2}, 1, 0)
expect(not foe:shielded(), "an attack ends the shield")
fall(high)
wait(1.3)
expect_near(foe:health(), 100 - 12 * (12 - 7.5), 1, "harm within 1.5 s after an attack")
