-- Two bots of the higher levels find each other, shoot, fetch what they need, and one of them dies of it.
match {set = {"quick.kills=1"}, seed = 4, players = {"bot 3", "bot 2"}}
trace("fight", {"1.health", "2.health", "1.energy", "2.energy"})
wait_until(function() return round_over() end, 240)
local over, how, winner = round_over()
expect(over and how == "kills", "a kill within four minutes")
expect(winner ~= nil, "by one of them")
expect(#events("shot") > 50, "both shot")
expect(#events {kind = "bolt_hit", by = 1} > 5 and #events {kind = "bolt_hit", by = 2} > 5, "and hit")
expect(#events("power_up") > 0, "somebody fetched something")
check_seek {count = 3}
