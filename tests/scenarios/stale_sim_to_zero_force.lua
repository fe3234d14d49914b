-- A match that stands still tells an arm nothing new. Its last force holds for 20 ms, walks to zero in 50 ms, on a line, and comes
-- back at 40 N/s once the match is there again. Nothing of that hangs on what the force was: here it is a full charge, 2.6 N on a
-- device of 3.3 N of which a gentle player wants 45 %.
match {players = {"script", "script"}, arms = {true, false}}
trace("stale", {"1.force_z", "1.readiness"})
local me = wizard(1)
local full = 0.45 * 2.6
me:press("wand_2")
me:look(0, 40)
me:hold("fire")
wait(2)
expect_near(me:readiness(), 1, 0, "charged")
expect_near(me:force().z, full, 1e-12, "the charge leans on the hand")
local caption = "Forces fade: the game or the arm is late"
expect(not on_screen(caption))

-- Sample k of the stall was felt by a model of k ticks.
local function held(k)
    if k <= 20 then return full end
    return full * math.max(70 - k, 0) / 50
end

-- The arm's force before, while and after; back says how many ticks at zero there are before it comes back.
local function stalled(ticks)
    stall(ticks / 1000)
    expect_near(me:told().z, held(ticks), 1e-12, "in the hand, while the match stands still")
    for k = 1, ticks do
        tick()
        expect_near(me:force().z, held(k), 1e-12, "the match computes what the hand had, sample " .. k)
        expect((me:force_cause() == "stale") == (k > 20), me:force_cause())
        expect(on_screen(caption) == (k > 20), "and says why")
    end
end
local function comes_back()
    local from = me:force().z
    for i = 1, 60 do
        tick()
        expect_near(me:force().z, math.min(full, from + 0.04 * i), 1e-9, "it walks back, tick " .. i)
        expect_near(me:told().z, me:force().z, 0)
    end
    expect_near(me:force().z, full, 1e-12)
    expect(me:force_cause() == "none" and not on_screen(caption))
end
stalled(20)   -- a hiccup is not felt
wait(0.1)
expect_near(me:force().z, full, 1e-12)
stalled(45)   -- half-way down the ramp
comes_back()
stalled(75)   -- zero
expect_near(me:told().z, 0, 0)
comes_back()

-- For longer than models are remembered: the match cannot say what the arm felt and both begin anew, from zero.
stall(0.2)
expect_near(me:told().z, 0, 0)
for k = 1, 79 do tick() expect_near(me:force().z, held(k), 1e-12) end
wait(0.2)
local before = me:force().z
for i = 1, 100 do
    tick()
    expect(math.abs(me:force().z - before) <= 0.04 + 1e-9, "no jump")
    before = me:force().z
end
expect_near(me:force().z, full, 1e-12, "and it is back")
