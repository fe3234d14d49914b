-- Two bots of high levels find each other, shoot and pick up what they need, and one of them dies.
match {set = {"quick.kills=1"}, seed = 2, players = {"bot 3", "bot 2"}}
trace("fight", {"1.health", "2.health", "1.energy", "2.energy"})
wait_until(function() return round_over() end, 240)
local over, how, winner = round_over()
expect(over and how == "kills", "a kill within four minutes")
expect(winner ~= nil, "by one of them")
expect(wizard(1):shots() > 10 and wizard(2):shots() > 10, "both shot")
for player = 1, 2 do
    local hits = 0
    for _, cause in ipairs {"bolt", "blast", "lob"} do hits = hits + deeds(player, cause).hits end
    expect(hits > 3, "and hit")
end
expect(#events("power_up") > 0, "somebody fetched something")
check_seek {count = 3}
