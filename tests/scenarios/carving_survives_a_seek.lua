-- A seek into carving, and to before anybody touched the crystal, leads to the same state as playing so far.
match {seed = 4, players = {"script", "bot 3"}, set = {"quick.kills=9"}}
local me = wizard(1)
local target = crystal(1).middle
if distance(crystal(2).middle, me:position()) < distance(target, me:position()) then target = crystal(2).middle end
local number = distance(target, crystal(1).middle) < 1 and 1 or 2
local function away()
    local p = me:position()
    return length {p.x - target.x, 0, p.z - target.z}
end
me:move(0, 1)
for _ = 1, 400 do
    me:aim {target.x, me:eye().y, target.z}
    wait(0.02)
    if away() < 1.6 then break end
end
me:stop()
expect(away() < 1.8, "the crystal is within reach: " .. away())
local untouched = now()
me:hold("stir")
wait(0.2)
me:hold("fire")
me:move(0, 1)
me:draw(1, 0, 0.6)
me:stop()
me:draw(-2, 1, 0.5)
local carving = now()
me:press("wand_2")
me:circles(1, 0.5, 2)
expect(crystal(number).touched, "the crystal was carved")
me:release("fire")
me:release("stir")
wait(0.5)
check_seek {ticks = {untouched, carving, now() - 700, now()}}
