-- A hundred hits in one tick: no motor gets more than its limit, all together no more than theirs, and no event is lost.
match {players = {"script", "script"}}
senses {layouts = {"x40", "x16", "pad"}}
local me, foe = wizard(1), wizard(2)
me:look(30, 0) -- the runner fails a scenario in which no player's action changes the match
wait(0.5)
local centre = me:centre()
for i = 1, 100 do
    happen {kind = i % 2 == 0 and "bolt_hit" or "blast_hit", subject = 1, by = 2, amount = 40,
        at = {centre.x + (i - 50) / 10, centre.y, centre.z + 4}}
end
local layouts = {"abstract_4x5", "x40", "x16", "pad"}
local most = {}
for _ = 1, 125 do
    tick(8)
    for _, layout in ipairs(layouts) do
        local sum = 0
        for i, cell in ipairs(body(1, layout)) do
            expect(cell.felt <= 1, layout .. ": cell " .. i .. " is within its limit")
            sum = sum + cell.felt * cell.felt
        end
        most[layout] = math.max(most[layout] or 0, sum)
    end
end
for _, layout in ipairs(layouts) do
    expect(most[layout] <= 1.5 + 1e-6, layout .. ": all together are within their limit")
    expect(most[layout] > 0.3, layout .. ": the hits are felt")
    local counts = body_counts(1, layout)
    expect_near(counts.offered, 100, 0, layout .. ": events")
    expect_near(counts.started + counts.merged, 100, 0, layout .. ": no event is lost")
end
wait(1)
for _, layout in ipairs(layouts) do
    for i, cell in ipairs(body(1, layout)) do expect_near(cell.felt, 0, 0, layout .. ": cell " .. i .. " at the end") end
end
