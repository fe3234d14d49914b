-- Without Boil-over, a tied round counts for neither player. Three tied rounds are a draw.
match {match = "standard", set = {"standard.seconds=2", "standard.interval_s=1", "standard.boil_over.seconds=0"}, players = {"script", "script"}}
for round = 1, 3 do
    expect_near(round_number(), round, 0)
    local ended = expect_event {kind = "round_end", within = 3.1}
    expect_near(ended.time, 2 * round, 0.02 * round, "each round lasts 2 s")
    local over, how, winner = round_over()
    expect(over and how == "time" and winner == nil, "the round is tied")
    local all_over, won = match_over()
    expect(all_over == (round == 3), "the match is over after the third round")
    expect(won[1] == 0 and won[2] == 0, "the match has no winner")
    wait(1.05)
end
expect_near(#events("round_begin"), 2, 0)
