-- A player with enough kills wins the round at once, and time stops.
match {match = "quick", set = {"quick.kills=1"}, players = {"script", "script"}}
local me, foe = wizard(1), wizard(2)
me:aim(foe)
me:move(0, 1)
wait(4)
me:stop()
wait(0.3)
me:aim(foe)
expect(not round_over(), "the round is not over yet")
me:hold("fire")
local death = expect_event {kind = "death", subject = 2, by = 1, within = 8}
local ending = expect_event {kind = "round_end", within = 0.1}
expect_near(ending.time, death.time, 0.008, "the round ends with the last kill")
expect_near(ending.subject, 1, 0, "the event names the winner")

local over, how, winner = round_over()
expect(over and how == "kills" and winner == 1, "player 1 wins by kills")
local at, shots, before = time(), me:shots(), state()
me:move(1, 0)
me:press("jump")
pause(2)
wait(4)
expect_near(time(), at, 0, "time stands still after the round")
expect_near(me:shots(), shots, 0, "no more shots although fire is held")
expect(foe:dead(), "no return to life after the round")
for _, change in ipairs(changes(before)) do
    expect(change.component == "Controls", change.component .. "." .. change.field .. " changed after the end")
end
