-- A match with late input in bursts, on a thread that sometimes stalls, has the same result.
match {seed = 5, players = {"script", "bot 1"}}
local me, foe = wizard(1), wizard(2)
for i = 1, 4 do
    me:aim(foe)
    me:hold("fire")
    me:move(i % 2 == 0 and 1 or -1, 0.6)
    wait(1)
    me:release("fire")
    me:press("jump")
    wait(0.5)
end
pause(1)
wait(0.3)
pause(1)
wait(0.5)
expect(me:shots() > 20, "the match has events")
for seed = 1, 3 do check_late {seed = seed} end
