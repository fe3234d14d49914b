-- From half of the round on, blows do more harm, first 1.5 and then 2 times as much. With equal kills at its end both
-- wizards have 30 HP, nothing gives them more, and the next to fall loses the round.
match {match = "quick", players = {"script", "script"},
       set = {"quick.seconds=12", "quick.surge.first.after_s=4", "quick.surge.second.after_s=8", "bolt.shot.damage=4",
              "bolt.shot.spread_deg=0", "quick.boil_over.seconds=30"}}
clear_props()
local me, foe = wizard(1), wizard(2)
me:place {-8, 0, 8}
foe:place {-8, 0, 14}
foe:aim(me)

local function harm_of_a_bolt()
    local before = me:health()
    foe:press("fire")
    expect_event {kind = "bolt_hit", subject = 1, within = 1}
    return before - me:health()
end
expect_near(harm_of_a_bolt(), 4, 1e-9, "before the surge")
local first = expect_event {kind = "surge", subject = 1, within = 5}
expect_near(first.time, 4, 0.01, "time of the first surge")
expect_near(first.amount, 1.5, 1e-9, "its factor")
expect_near(harm_of_a_bolt(), 6, 1e-9, "in the first surge")
expect_near(expect_event {kind = "surge", subject = 2, within = 5}.amount, 2, 1e-9, "the second surge")
expect_near(harm_of_a_bolt(), 8, 1e-9, "in the second surge")

local tied = expect_event {kind = "tied", subject = 2, within = 6}
expect_near(tied.time, 12, 0.01, "the time is up")
expect(not round_over(), "the round goes on")
wait(0.05)
expect_near(me:health(), 30, 1e-9, "health of the first wizard")
expect_near(foe:health(), 30, 1e-9, "health of the second wizard")
foe:hold("fire")
local ending = expect_event {kind = "round_end", within = 5}
foe:release("fire")
local over, how, winner = round_over()
expect(over and how == "boil_over" and winner == 2, "who is left standing wins the round: " .. tostring(how))
