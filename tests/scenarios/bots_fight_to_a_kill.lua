-- Two bots of high levels find each other, shoot and pick up what they need, and one of them dies.
match {set = {"quick.kills=1"}, seed = 6, players = {"bot 3", "bot 2"}}
trace("fight", {"1.health", "2.health", "1.energy", "2.energy"})
wait_until(function() return round_over() end, 240)
local over, how, winner = round_over()
expect(over and how == "kills", "a bot dies within four minutes")
expect(winner ~= nil, "the other bot killed it")
expect(wizard(1):shots() > 10 and wizard(2):shots() > 10, "both bots shoot")
for player = 1, 2 do
    local hits = 0
    for _, cause in ipairs {"bolt", "blast", "lob"} do hits = hits + deeds(player, cause).hits end
    expect(hits > 3, "both bots hit")
end
expect(#events("power_up") > 0, "a bot picks up a power-up")
check_seek {count = 3}
