-- An arm's servo is part of the state: moved faders, a largest force that is taken away and given back, and surfaces
-- near the tip leave nothing behind that a seek does not restore.
match {players = {"script", "bot 1"}, arms = {true, false}, seed = 4}
local me = wizard(1)
wait(0.5)
me:move(0, 1)
wait(0.5)
me:fader("force", 60)
wait(0.5)
me:fader("force", 0)
wait(0.8)
me:press("wand_3")
me:hold("fire")
wait(0.6)
me:release("fire")
me:fader("force", 80)
wait(0.4)
me:press("wand_1")
me:hold("fire")
wait(1.5)
me:stop()
expect(now() > 2 * 2048, "the match has several keyframes")
check_seek {ticks = {2048, 2100, 2500, 3000, now()}}
check_seek {count = 8, seed = 5}
