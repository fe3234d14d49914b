-- States and forces of a match are the same while it is heard and felt, while it is not, and when all outputs die in the
-- middle of it.
match {players = {"script", "bot 3"}, seed = 3}
trace("hand", {"1.force_x", "1.force_y", "1.force_z"})
senses {layouts = {"x40", "x16", "pad"}}
local me, foe = wizard(1), wizard(2)
local felt, words = 0, 0
for i = 1, 8 do
    me:aim(foe)
    me:hold("fire")
    me:move(i % 2 == 0 and 0.5 or -0.5, 1)
    wait(1)
    for _, cell in ipairs(body(1, "x40")) do felt = math.max(felt, cell.felt) end
    words = words + #heard(1)
    me:release("fire")
    if i == 4 then me:press("next_wand") end
    wait(0.2)
end
me:stop()
expect(words > 0, "something is told")
check_senses {layouts = {"x40", "x16", "pad"}}
check_senses {layouts = {"x40", "x16", "pad"}, quit = 4}
