-- A wizard with a real arm scries: the arm's own thread feels the modes, and a seek leads to the same state and forces.
match {players = {"script", "bot 1"}, arms = {true, false}, seed = 4, set = {"quick.kills=9"}}
local me = wizard(1)
me:walk_to(-15, 0)
me:walk_to(-16.7, 0)
wait(0.3)
me:scry(3)
expect(me:scrying(), "the wizard scries")
local told = 0
for _, place in ipairs {{0.03, 0, 0}, {0, 0.03, 0}, {-0.03, 0, 0.01}} do
    me:reach(place, 0.1)
    for _ = 1, 600 do
        tick()
        told = math.max(told, length(me:told()))
    end
end
expect(told > 0.2, "the thread of the arm pushed with " .. told .. " N")
expect(me:scrying().distance > 0.06, "the core is elsewhere")
local searching = now()
me:reach((me:core()), 0.1)
wait_until(function() return me:scrying().near end, 3)
wait(1.6)
expect_event {kind = "scried", subject = 1}
check_seek {ticks = {searching, searching + 300, now()}}
check_seek {count = 4, seed = 2}
