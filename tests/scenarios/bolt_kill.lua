-- A player walks up to the foe, aims and holds fire. 17 hits of 6 HP kill, and the shooter scores.
match {players = {"script", "script"}}
trace("fight", {"1.z", "2.health", "1.energy", "1.shots"})

local me, foe = wizard(1), wizard(2)
expect(distance(me:position(), foe:position()) > 20, "the wizards begin far apart")
me:aim(foe)
me:move(0, 1)
wait_until(function() return distance(me:position(), foe:position()) < 12 end, 10)
me:stop()
wait(0.3)
me:aim(foe)
me:hold("fire")
wait_until(function() return foe:dead() end, 5)
me:release("fire")

local hits = events {kind = "bolt_hit", subject = 2, by = 1}
expect_near(#hits, 17, 0, "number of hits that kill")
for i, hit in ipairs(hits) do expect_near(hit.amount, 6, 0, "hit " .. i) end
local death = expect_event {kind = "death", subject = 2, by = 1}
expect_near(death.time, hits[17].time, 0.008, "time between the last hit and the death")

-- 17 shots at 8 a second take 2 s from the first to the last. Their flight times are equal.
expect_near(hits[17].time - hits[1].time, 16 / 8, 0.02, "time from the first hit to the last")
expect_near(me:kills(), 1, 0, "kills of the shooter")
expect_near(me:deaths(), 0, 0)
expect_near(foe:kills(), 0, 0)
expect_near(foe:deaths(), 1, 0, "deaths of the victim")
expect_near(me:health(), 100, 0, "health of the shooter")
