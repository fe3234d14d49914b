-- A jacket whose link dies while a blast is felt plays the last frame for 48 ms at most, and then nothing.
match {players = {"script", "script"}}
senses {layouts = {"x16", "pad"}}
local me = wizard(1)
me:look(10, 0)
wait(0.3)
local centre = me:centre()
happen {kind = "blast_hit", subject = 1, by = 2, amount = 60, at = {centre.x, centre.y, centre.z - 5}}
wait(0.04)

local function strongest(layout, age)
    local most = 0
    for _, cell in ipairs(body(1, layout, age)) do most = math.max(most, cell.felt) end
    return most
end

for _, layout in ipairs {"x16", "pad"} do
    local felt = strongest(layout)
    expect(felt > 0.1, layout .. ": the blast is felt")
    expect_near(strongest(layout, 0.047), felt, 0, layout .. ": within the time to live")
    expect_near(strongest(layout, 0.048), 0, 0, layout .. ": after it")
    expect_near(strongest(layout, 5), 0, 0, layout .. ": much later")
end
