-- Faders that were moved in one round count in all later ones, and a seek into a later round feels the same.
match {players = {"script", "script"}, seed = 2, match = "standard", set = {"standard.seconds=3", "standard.interval_s=1", "standard.boil_over.seconds=0"}}
local me = wizard(1)
me:fader("recoil", 20)
me:hold("fire")
wait(1)
local function kick()
    local most = 0
    for _ = 1, 400 do
        tick()
        most = math.max(most, me:force().z)
    end
    return most
end
local first = kick()
wait_until(function() return round_number() == 2 end, 6)
wait(0.5)
expect_near(kick(), first, 0.02, "the kick in the second round")
wait(2)
check_seek {ticks = {1000, 2999, 4000, 5000, 6000, now()}}
