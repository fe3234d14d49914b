-- The panic key of either player sets the forces on both hands to zero at once. They stay zero until each
-- player presses it again.
match {players = {"script", "script"}}
trace("forces", {"1.force_z", "2.force_z"})

local one, two = wizard(1), wizard(2)
local function strongest(who, seconds)
    local last, most = time() + seconds, 0
    while time() < last do
        tick()
        most = math.max(most, math.abs(who:force().z))
    end
    return most
end

one:look(0, 40)
one:hold("fire")
wait_until(function() return one:force().z > 0.4 end, 1)
two:hold("panic")
tick()
expect_near(one:force().z, 0, 0, "no force in the middle of a kick")
expect(one:force_cause() == "panic" and two:force_cause() == "panic", "both players see the reason")
two:release("panic")
expect_near(strongest(one, 1), 0, 0, "shots go on without force")
expect(one:shots() > 8)

one:press("panic")
expect(strongest(one, 1) > 0.5, "forces are felt again")
expect(one:force_cause() == "none" and two:force_cause() == "panic", "each player ends the panic for one hand only")
one:release("fire")
two:press("panic")
tick()
expect(two:force_cause() == "none")
