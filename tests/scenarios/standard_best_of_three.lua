-- A standard match is the best of three rounds. Each round begins like the first. The next one begins when a
-- player confirms, or after 12 s.
match {match = "standard", set = {"standard.kills=2", "bolt.shot.damage=50", "bolt.shot.spread_deg=0"},
       players = {"script", "script"}}
local a, b = wizard(1), wizard(2)

-- Both shoot across the arena along their starting line, x = -15. A killed wizard returns elsewhere.
local function play_round(winner, loser)
    local number = round_number()
    for _ = 1, 2 do
        local walks = 0
        while not loser:dead() and not round_over() do
            winner:aim(loser)
            wait(0.6)
            winner:hold("fire")
            for _ = 1, 20 do
                if not round_over() then wait(0.05) end
            end
            winner:release("fire")
            walks = walks + 1
            if walks > 3 and not round_over() then winner:move(0, 1) wait(1) winner:stop() end
            if walks > 20 then fail("the wizard was never hit") end
        end
        if not round_over() then wait_until(function() return not loser:dead() end, 4) wait(1.6) end
    end
    expect(round_over(), "round " .. number .. " is over")
end

expect_near(round_number(), 1, 0)
local start = a:position()
play_round(a, b)
local over, won = match_over()
expect(not over and won[1] == 1 and won[2] == 0, "the match goes on after one round")
local before = time()
a:move(0, 1)
a:press("confirm", 0.1)
wait(1)
expect_near(time(), before, 0, "play stands still between rounds")
expect_near(round_number(), 1, 0, "a confirmation right after the end does not count")
a:stop()
b:press("confirm", 0.1)
wait(0.1)
expect_near(round_number(), 2, 0, "number of the next round")
expect(not round_over())
expect_near(distance(a:position(), start), 0, 0.02, "the player starts from the same pad")
expect_near(a:kills(), 0, 0)
expect_near(a:shots(), 0, 0)
expect_near(b:health(), 100, 0)
expect_near(deeds(1, "bolt").kills, 2, 0, "the match counts won rounds")

play_round(b, a)
over, won = match_over()
expect(not over and won[1] == 1 and won[2] == 1, "one round for each player")
wait(11)
expect_near(round_number(), 2, 0)
wait(1)
expect_near(round_number(), 3, 0, "the next round begins after 12 s by itself")

play_round(a, b)
over, won = match_over()
expect(over and won[1] == 2 and won[2] == 1, "player 1 wins the match by 2 to 1")
wait(13)
b:press("confirm", 0.1)
expect_near(round_number(), 3, 0, "there is no fourth round")
expect_near(deeds(1, "bolt").kills, 4, 0, "kills in all rounds")
expect_near(deeds(2, "bolt").kills, 2, 0)
check_seek {count = 5}
