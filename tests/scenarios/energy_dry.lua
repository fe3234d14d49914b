-- The bolt wand holds 60 energy, a shot costs 1.5, and 1 returns each second. With fire held, the wand shoots
-- 8 times a second until it is empty. After that it shoots only as often as the energy returns.
match {players = {"script", "script"}}
trace("energy", {"1.energy", "1.shots"})

local cap, cost, regain, rate = 60, 1.5, 1, 8
local me = wizard(1)
me:look(0, 40)
expect_near(me:energy(), cap, 0)
wait(0.5)
expect_near(me:energy(), cap, 0, "a full wand stays full")

-- Shot k (from 0) is fired at k / rate, and needs cap + regain * k / rate - cost * k >= cost.
local last = (cap - cost) // (cost - regain / rate)
me:hold("fire")
local began = time()
wait_until(function() return me:energy() < cost end, 10)
expect_near(me:shots(), last + 1, 0, "number of shots without a pause")
expect_near(time() - began, last / rate, 0.03, "time of these shots")

local shots = events {kind = "shot", by = 1}
for i = 2, #shots do
    local early, late = shots[i - 1].time, shots[i].time
    expect(late - early >= 0.117 and late - early <= 0.133, "time between two shots")
end

-- An empty wand shoots once in 1.5 s.
local before = me:shots()
wait(12)
expect_near(me:shots() - before, 12 * regain / cost, 1, "shots in 12 s from regained energy")
me:release("fire")
wait(0.2)
expect_near(#events("dry"), 0, 0, "no dry event while fire is only held")

if me:energy() >= cost then me:press("fire") end
expect(me:energy() < cost, "the energy is too low for a shot")
me:press("fire", 0.1)
expect_event {kind = "dry", subject = 1, within = 0.2}

local left, at = me:energy(), time()
wait(5)
expect_near(me:energy() - left, regain * (time() - at), 0.02, "energy regained per second")
me:press("fire")
expect_near(#events {kind = "shot", by = 1}, me:shots(), 0, "one event for every shot")
