-- A vial gives 25 HP to a wizard who walks over it. It returns after 20 s.
match {players = {"script", "script"}}
trace("healing", {"1.health", "1.x", "1.z"})
local me, foe = wizard(1), wizard(2)

local function vial()
    for _, p in ipairs(power_ups()) do
        if p.kind == "vial" and distance(p.place, {-17, 0, 8}) < 0.1 then return p end
    end
end

-- The foe shoots from the other end of the arena.
foe:aim(me)
wait(0.5)
foe:hold("fire")
wait_until(function() return me:health() < 60 end, 5)
foe:release("fire")
wait(1.5)
local hurt = me:health()
expect(hurt <= 60 and hurt > 0, "the wizard is hurt")
expect(vial().there, "the vial is there")

me:aim {-17, 1.6, 8}
wait(0.8)
me:move(0, 1)
local taken = expect_event {kind = "power_up", subject = 1, within = 4}
me:stop()
expect_near(distance(me:position(), {-17, 0, 8}), 0.9, 0.1, "distance at which the vial is picked up")
expect_near(taken.amount, 25, 0)
expect_near(taken.detail, 0, 0, "kind of the power-up")
expect_near(me:health(), hurt + 25, 1e-9)
expect(not vial().there, "the vial is gone")
expect_near(vial().back_in, 20, 0.01, "time until the vial is back")
wait(19.9)
expect_near(me:health(), hurt + 25, 1e-9, "no healing while the vial is gone")

-- A wizard who still stands there gets the next vial.
local again = expect_event {kind = "power_up", subject = 1, within = 0.2}
expect_near(again.time - taken.time, 20, 0.008, "time between two vials")
expect_near(me:health(), hurt + 50, 1e-9)
expect_near(#events {kind = "power_up", subject = 2}, 0, 0, "the foe got no power-up")
check_seek {count = 3}
