-- A hand that moves faster than 4 m/s gets no force at once. The force returns at 40 N/s once the hand has
-- been slower than 2 m/s for 100 ms. Speed is measured over 8 ms, and along the path over 7 ms, less the
-- possible error of the encoder.
match {players = {"script", "script"}, arms = {true, false}}
trace("fling", {"1.force_z", "1.hand_x"})
local me = wizard(1)
local full = 0.45 * 2.6
me:press("wand_2")
me:look(0, 40)
me:reach {-0.08, 0, 0}
me:hold("fire")
wait(2)
expect_near(me:force().z, full, 1e-12, "force of a full charge")
local caption = "Forces wait until the hand is slower"

-- A fast hand below the limit: 0.156 m at 3.9 m/s.
me:reach({0.076, 0, 0}, 3.9)
for _ = 1, 60 do
    tick()
    expect_near(me:force().z, full, 1e-12, "force below the speed limit")
end

-- Back at 5 m/s, 0.15 m in 30 ms. Tick 6 is the first above 4 m/s, since its window sees 6/7 of the speed.
-- The last tick above 2 m/s is 4 ticks after the stop, where the window sees half. The cut-out ends 100 ticks
-- later.
me:reach({-0.074, 0, 0}, 5)
local last_fast = 30 + 4
for i = 1, 220 do
    tick()
    local force = me:force().z
    if i < 6 then
        expect_near(force, full, 1e-12, "full force before the cut-out, tick " .. i)
    elseif i <= last_fast + 100 then
        expect_near(force, 0, 0, "no force during the cut-out, tick " .. i)
        expect(me:force_cause() == "over_speed" and on_screen(caption), "the screen gives the reason")
    else
        expect_near(force, math.min(full, 0.04 * (i - last_fast - 100)), 1e-9, "the force returns slowly, tick " .. i)
        expect(me:force_cause() == "none" and not on_screen(caption))
    end
    expect_near(me:told().z, force, 0)
end

-- A jump of the arm by 4 cm in one tick counts as 5 m/s over the window.
me:reach {-0.034, 0, 0}
tick()
expect_near(me:force().z, 0, 0, "no force in the tick of the jump")
wait(0.1)
expect_near(me:force().z, 0, 0)
wait(0.1)
expect_near(me:force().z, full, 1e-9, "the force is back")
