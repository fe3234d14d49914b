-- Blast and lob do not regain energy by themselves. An empty wand clicks until a spark fills half of the
-- emptiest wand.
match {players = {"script", "script"}}
trace("energy", {"1.energy", "1.shots", "1.force_z"})
local me = wizard(1)
me:place {-11.5, 0, 6}
me:face(0, 30)

local function shoot(seconds)
    me:hold("fire")
    wait(seconds)
    if seconds == 2 then  -- a blast at full charge
        expect_near(me:force().z, 0.45 * 2.6 * me:readiness(), 1e-9, "force on the hand grows with the charge")
    end
    me:release("fire")
    wait(0.3)
end

-- Four throws of 12 energy empty the lob's 48. A fifth clicks.
me:press("wand_3")
for i = 1, 4 do
    shoot(0.5)
    expect_near(me:energy(), 48 - 12 * i, 1e-9, "energy of a throw")
end
expect_near(me:shots(), 4, 0)
me:press("fire", 0.5)
local dry = expect_event {kind = "dry", subject = 1}
expect_near(length(me:force()), 0, 0, "no spring without energy")
wait(0.3)
expect_near(me:shots(), 4, 0)

-- Two full blasts cost 25 each, and a third uses the remaining 10.
me:press("wand_2")
shoot(2)
shoot(2)
expect_near(me:energy(), 10, 1e-9)
shoot(2)
expect_near(me:energy(), 0, 1e-9)
expect_near(me:shots(), 7, 0)
me:press("fire", 0.5)
expect_event {kind = "dry", subject = 1}
wait(3)
expect_near(me:energy(), 0, 1e-9, "energy does not come back by itself")

-- Two wands are empty. The spark fills half of the first by name, which is blast: 30 of 60.
me:move(0, 1)
local taken = expect_event {kind = "power_up", subject = 1, within = 3}
me:stop()
expect_near(taken.detail, 2, 0, "kind of the power-up")
expect_near(taken.amount, 30, 0)
expect_near(me:energy(), 30, 1e-9)
me:press("wand_3")
expect_near(me:energy(), 0, 1e-9, "the other wand stays empty")
wait(15.1)
taken = expect_event {kind = "power_up", subject = 1, within = 0.2}
expect_near(taken.amount, 24, 0, "energy from the spark")
expect_near(me:energy(), 24, 1e-9)
shoot(0.5)
expect_near(me:shots(), 8, 0, "the sling shoots again")
