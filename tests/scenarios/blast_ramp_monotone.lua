-- While the blast wand is charged, its steady force on the hand grows in proportion to the charge. The shot
-- kicks in proportion to its energy and speed. The force setting is 45 % of a device of 3.3 N.
match {players = {"script", "script"}}
trace("charge", {"1.force_z", "1.hand_z", "1.readiness", "1.energy", "2.force_z"})

local me, foe = wizard(1), wizard(2)
local share, from, full = 0.45, 0.3, 1.6
local felt_by_foe = 0
me:press("wand_2")
expect_near(me:energy(), 60, 0, "the blast wand is full")
me:look(0, 40)

local function feel()
    tick()
    felt_by_foe = felt_by_foe + math.abs(foe:force().z)
    expect_near(me:force().x, 0, 0)
    expect_near(me:force().y, 0, 0)
    return me:force().z
end

-- Charges for some seconds. The hand feels a charge one tick after the wand has looked at the fire button. No
-- force is left from an earlier kick.
local function charge_for(seconds)
    me:hold("fire")
    local began, before = nil, 0
    local last = time() + seconds
    while time() < last do
        local c = me:readiness()  -- charge by which the next tick's force is computed
        local force = feel()
        expect_near(force, share * 2.6 * c, 1e-12, "force in proportion to the charge")
        expect(force >= before, "force never falls while charging")
        before = force
        if not began and me:readiness() > 0 then began = time() end
    end
    return began, before
end

-- A release before 0.3 s fires no shot and costs no energy.
charge_for(0.2)
me:release("fire")
for _ = 1, 100 do expect_near(feel(), 0, 0, "no force after a charge that was too short") end
expect_near(me:shots(), 0, 0)
expect_near(me:energy(), 60, 0)

-- Expected force after the release: the kick, which replaces the steady force while it rises.
local function recoil(c)
    local energy, speed = 8 + 17 * c, 18 + 14 * c
    local peak, n = share * 3.0 * (energy / 25) * (speed / 32), 60
    local impulse = 0
    for i = 0, n - 1 do
        local half_sine = math.sin(math.pi / (2 * n)) / (math.pi / (2 * n)) * math.sin((2 * i + 1) * math.pi / (2 * n))
        local given_way = 2 * i < n and half_sine or 1
        impulse = impulse + (peak * half_sine + share * 2.6 * c * (1 - given_way)) * 0.001
    end
    return impulse, peak
end

local function go_off(c)
    local shots, energy = me:shots(), me:energy()
    me:release("fire")
    while me:shots() == shots do feel() end  -- the charge grows until the wand reads the button
    local charge = (energy - me:energy() - 8) / 17
    local impulse, greatest = 0, 0
    for _ = 1, 130 do
        local f = feel()
        impulse, greatest = impulse + f * 0.001, math.max(greatest, f)
    end
    local expected, peak = recoil(charge)
    expect_near(charge, c, 0.02, "charge of the shot")
    expect_near(impulse, expected, 1e-9, "impulse of the recoil")
    return impulse, peak, greatest, charge
end

-- A minimal charge: the steady force is small, so the impulse is nearly 2/pi x peak x length.
charge_for(0.312)
local impulse, peak = go_off(0.01)
expect_near(impulse, 2 / math.pi * peak * 0.06, 0.015 * impulse, "impulse of a half sine")

-- Half a charge and a full charge.
local began = charge_for(0.95)
go_off(0.5)
local _, most = charge_for(2.2)
expect_near(most, share * 2.6, 1e-9, "force of a full charge")
local _, top, greatest, charge = go_off(1)
expect_near(charge, 1, 0)
expect_near(top, share * 3.0, 1e-12)
expect_near(greatest, top, 0.002 * top, "peak of the recoil")

-- 60 = 8.2 + 16.5 + 25 + 10.4: the remaining energy limits the last charge.
local left = me:energy()
local c = (left - 8) / 17
expect(c > 0 and c < 0.9, "the energy is too low for a full charge")
local _, lean = charge_for(2)
expect_near(lean, share * 2.6 * c, 1e-9, "force of the largest charge that the energy allows")
go_off(c)
expect_near(me:energy(), 0, 1e-9)
me:press("fire", 0.5)
expect_event {kind = "dry", subject = 1}
expect_near(me:shots(), 4, 0)
expect_near(felt_by_foe, 0, 0, "no force on the other hand")
