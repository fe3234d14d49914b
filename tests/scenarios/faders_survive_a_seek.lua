-- Faders that were moved belong to the state of the match: playing on from a later moment feels and does the same.
match {seed = 11, players = {"script", "bot 1"}}
local me, foe = wizard(1), wizard(2)
local faders = {"recoil", "force", "weight", "blows", "roughness", "brew flow"}
for i = 1, 6 do
    me:fader(faders[i], 15 * i)
    me:aim(foe)
    me:hold("fire")
    me:move(i % 2 == 0 and 0.7 or -0.7, 1)
    wait(1.3)
    me:release("fire")
    me:press("jump")
    me:look(60, -20)
    wait(0.6)
end
expect(now() > 4 * 2048, "the match has several keyframes")
check_seek {ticks = {0, 1, 2047, 2048, 2049, 4096, 6143, now()}}
check_seek {count = 12, seed = 3}
check_late {}
