-- No hand meets a large force when forces return. They return after a panic, or when the match has lost sight
-- of an arm. If the arm then pulls with more than the force limit, the hand gets no force until it has eased
-- off. Then the withheld force fades in at 40 N/s, from zero.
match {players = {"script", "script"}, arms = {true, false}, set = {"lift.energy.per_s=0", "lift.energy.per_n_s=0"}}
clear_props()
local me = wizard(1)
local cap = 0.45 * 3.3
wizard(2):place {-15, 0, -15}
me:place {16.5, 0, 16}
me:face(-90, 0)
local thing = spawn {kind = "box", size = {1, 1, 1}, mass = 20, at = {19.5, 0.5, 16}}  -- at the wall
trace("gate", {"1.force_y", "1.force_z", "1.hand_z"})
local caption = "Forces wait until the pull is small"
wait(0.3)
me:press("wand_4")
me:aim(thing)
wait(0.1)
me:hold("fire")
wait(0.5)
local rest = length(me:force())
expect(rest < 0.3, "only the weight is felt, through the fader")

-- A hand 8 mm forward is 16 cm into the wall. The spring of 300 N/m asks for 2.4 N, but the hand feels only
-- the force limit.
local depth = 0.008
local function press()
    me:reach({0, 0, -depth}, 0.05)
    wait(0.5)
    expect_near(length(me:force()), cap, 1e-9, "the pressed hand's force is capped")
    expect(me:force_cause() == "capped")
end

-- Checks the force while the hand eases off at 2 cm/s. The wait ends where 300 N/m come down to the limit.
local function ease_off()
    for _ = 1, 200 do
        tick()
        expect_near(length(me:force()), 0, 0, "no force while the hand is pressed")
        expect(me:force_cause() == "waiting" and on_screen(caption), "the screen gives the reason")
    end
    me:reach({0, 0, 0}, 0.02)
    local waited = 0
    while me:force_cause() == "waiting" do
        expect_near(length(me:force()), 0, 0)
        tick()
        waited = waited + 1
    end
    expect_near(300 * -me:hand().z, cap, 0.1, "the force waits until the spring is within the cap")
    expect(not on_screen(caption))
    -- The offset starts at minus the spring force and shrinks by 0.04 N a tick. The spring force itself,
    -- which falls as the hand eases off, is not delayed. From the second tick on, a brake acts, because the
    -- spring holds more energy than it received; it takes up to 0.08 N.
    local before, first = {0, 0, 0}, 300 * -me:hand().z
    for i = 1, 25 do
        local force = me:force()
        local step, eased = distance(force, before), first - 300 * -me:hand().z
        expect(step <= 0.05, "no jump of the force, tick " .. i)
        expect_near(length(force), 0.04 * i - eased, 0.085, "the force grows from zero, tick " .. i)
        before = force
        tick()
    end
    wait(0.5)
    expect_near(length(me:force()), rest, 0.05, "the force is as before")
end

press()
me:press("panic")
wait(0.2)
expect_near(length(me:force()), 0, 0, "panic")
me:press("panic")
wait(0.1)
ease_off()

-- The match loses sight of the arm for longer than it remembers.
press()
stall(0.2)
wait(0.3)
ease_off()
