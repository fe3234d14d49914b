-- Either player can pause and either can go on. During a pause nothing happens, and keys pressed then have no
-- later effect.
match {players = {"script", "script"}}
local me, foe = wizard(1), wizard(2)
me:move(0, 1)
foe:move(1, 0)
me:hold("fire")
wait(0.7)
me:press("jump")  -- pause during a jump, with bolts in flight
wait(0.1)

local function expect_still(before, what)
    for _, change in ipairs(changes(before)) do
        local name = change.component .. "." .. change.field
        local pausing = name == "Match.paused" or name == "Match.paused_by"
        expect(change.component == "Controls" or pausing, what .. ": " .. name .. " changed in a pause")
    end
end

for _, players in ipairs {{1, 1}, {1, 2}, {2, 1}, {2, 2}} do
    pause(players[1])
    expect(paused(), "player " .. players[1] .. " can pause")
    local before, at, shots = state(), time(), me:shots()
    me:look(30, 10)
    foe:press("jump")
    foe:press("next_wand")
    foe:press("fire")
    foe:move(-1, -1)
    wait(2)
    foe:move(1, 0)
    expect_near(time(), at, 0, "time stands still in a pause")
    expect_near(me:shots(), shots, 0, "no shots in a pause")
    expect_still(before, "paused by " .. players[1])
    pause(players[2])
    expect(not paused(), "player " .. players[2] .. " can go on")
    wait(0.3)
    expect_near(time() - at, 0.3, 0.03, "time goes on after the pause")
    expect(me:shots() > shots, "fire that is still held shoots again")
    expect_near(#events {kind = "shot", by = 2}, 0, 0, "presses during the pause have no later effect")
end
me:release("fire")
wait(1)
expect(foe:grounded(), "no jump from a press during the pause")
