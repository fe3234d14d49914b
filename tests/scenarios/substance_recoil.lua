-- Dropping an ingredient kicks the hand. Without an ingredient there is no kick.
match {players = {"script", "script"}, set = {"haptics.share=1"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
local function most_force()
    local most = 0
    me:hold("fire")
    for _ = 1, 150 do
        tick()
        most = math.max(most, length(me:force()))
    end
    me:release("fire")
    return most
end
trace("recoil", {"1.force_x", "1.force_y", "1.force_z"})
me:place {-2.2, 0, 0}
me:hold("stir")
wait(0.5)
expect(most_force() < 0.05, "no force before the drop")
me:release("stir")
wait(0.1)
me:place {-4.5, 0, 0}
wait(0.1)
me:place {-2.2, 0, 0}
me:hold("stir")
wait(0.5)
expect(most_force() > 0.3, "the drop is felt")
expect(#brew().contents == 1)
