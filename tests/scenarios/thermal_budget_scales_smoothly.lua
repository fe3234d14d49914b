-- A hand presses a held thing against a wall for a long time. Without a limit the device would overheat.
-- After a while all forces are scaled down smoothly. The root mean square of the force over any ten seconds
-- stays below the continuous limit, 0.88 N for a Touch.
match {players = {"script", "script"}, forces = {100, 100},
       set = {"lift.energy.per_s=0", "lift.energy.per_n_s=0", "lift.hold.lost_m=10"}}
clear_props()
local me = wizard(1)
wizard(2):place {-15, 0, -15}
me:place {14.5, 0, 16}
me:face(-90, 0)
local thing = spawn {kind = "box", size = {1, 1, 1}, mass = 20, at = {17.5, 0.5, 16}}
trace("warm", {"1.force_x", "1.force_y", "1.force_z", "t1.x"})
wait(0.3)
me:press("wand_4")
me:aim(thing)
wait(0.1)
me:hold("fire")
wait(0.2)
me:look(0, 10)
wait(1)
me:move(0, 0.4)
wait_until(function() return thing:position().x > 19.49 end, 3)
wait(0.12)  -- the blow is over
wait_until(function() return me:force().z > 1.4 end, 3)
me:stop()
wait(0.4)
expect(length(me:force()) > 1.2, "the hand presses hard")
expect(me:force_cause() == "none", "the force is not reduced yet")
local squares, sum, before, warm, steepest = {}, 0, me:force(), false, 0
for i = 1, 16000 do
    tick()
    local now = me:force()
    steepest = math.max(steepest, distance(now, before))
    before = now
    warm = warm or me:force_cause() == "warm"
    local size = length(now)
    squares[i] = size * size
    sum = sum + squares[i]
    if i > 10000 then sum = sum - squares[i - 10000] end
    if i >= 10000 then expect(math.sqrt(sum / 10000) <= 0.88 + 1e-9, "mean square force stays within the motors' limit") end
end
expect(warm, "the reduced force has its reason")
-- One encoder count, 55 um, changes the force through a spring of 300 N/m. Through the velocity over 8 ms it
-- also acts on a damper of 1.9 N s/m, and on up to 4 N s/m of the controller.
expect(steepest < 5.5e-5 * (300 + (1.9 + 4) / 0.008) + 0.003, "change of force per tick is at most that of one encoder count")
expect(length(me:force()) > 0.05, "the force is reduced but not zero")
expect_near(thing:position().x, 19.5, 0.01, "the reduced force does not move the thing")
expect(me:created() < 0.001, "a thing at rest at a wall gives the hand no energy")
