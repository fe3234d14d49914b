-- A match that stands still gives an arm no new orders. The last force holds for 20 ms and then falls
-- linearly to zero within 50 ms. It returns at 40 N/s when the match goes on. This does not depend on the
-- force. Here it is a full charge, 2.6 N on a device of 3.3 N at a force setting of 45 %.
match {players = {"script", "script"}, arms = {true, false}}
trace("stale", {"1.force_z", "1.readiness"})
local me = wizard(1)
local full = 0.45 * 2.6
me:press("wand_2")
me:look(0, 40)
me:hold("fire")
wait(2)
expect_near(me:readiness(), 1, 0, "the wand is charged")
expect_near(me:force().z, full, 1e-12, "force of a full charge")
local caption = "Forces fade: the game or the arm is late"
expect(not on_screen(caption))

-- Force of sample k of the stall, from an order that is k ticks old.
local function held(k)
    if k <= 20 then return full end
    return full * math.max(70 - k, 0) / 50
end

-- Checks the arm's force before, during and after a stall.
local function stalled(ticks)
    stall(ticks / 1000)
    expect_near(me:told().z, held(ticks), 1e-12, "force on the hand while the match stands still")
    for k = 1, ticks do
        tick()
        expect_near(me:force().z, held(k), 1e-12, "force that the match computes for sample " .. k)
        expect((me:force_cause() == "stale") == (k > 20), me:force_cause())
        expect(on_screen(caption) == (k > 20), "the screen gives the reason")
    end
end
local function comes_back()
    local from = me:force().z
    for i = 1, 60 do
        tick()
        expect_near(me:force().z, math.min(full, from + 0.04 * i), 1e-9, "the force returns slowly, tick " .. i)
        expect_near(me:told().z, me:force().z, 0)
    end
    expect_near(me:force().z, full, 1e-12)
    expect(me:force_cause() == "none" and not on_screen(caption))
end
stalled(20)  -- the hand does not feel a short stall
wait(0.1)
expect_near(me:force().z, full, 1e-12)
stalled(45)  -- half-way down the ramp
comes_back()
stalled(75)  -- zero
expect_near(me:told().z, 0, 0)
comes_back()

-- A stall longer than the match remembers orders: the match cannot compute the arm's force, and both start
-- again from zero.
stall(0.2)
expect_near(me:told().z, 0, 0)
for k = 1, 79 do tick() expect_near(me:force().z, held(k), 1e-12) end
wait(0.2)
local before = me:force().z
for i = 1, 100 do
    tick()
    expect(math.abs(me:force().z - before) <= 0.04 + 1e-9, "no jump of the force")
    before = me:force().z
end
expect_near(me:force().z, full, 1e-12, "the force is back")
