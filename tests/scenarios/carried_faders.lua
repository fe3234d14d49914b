-- The weight of a carried thing and the blows on it have a fader each. A player with half the weight and no
-- blows feels exactly that. The thing stays as heavy and as hard to stop as for the foe with 100 % of both.
match {players = {"script", "script"}, weights = {50, 100}, blows = {0, 100}, set = {"haptics.share=1"}}
clear_props()
local mass = 30

local function carry(me, foe, z)
    me:place {8, 0, z}
    me:face(-90, 0)
    foe:place {18, 0, z}
    foe:face(90, 0)
    local shield = spawn {kind = "box", size = {1, 1, 1}, mass = mass, at = {11, 0.5, z}}
    wait(0.3)
    me:press("wand_4")
    me:aim(shield)
    wait(0.1)
    me:hold("fire")
    wait(0.1)
    me:look(0, 15)
    wait(2)
    local still = me:force()
    foe:press("wand_1")
    foe:aim(me)
    wait(0.2)
    foe:press("fire")
    local strongest, pushed = 0, 0
    for _ = 1, 200 do
        tick()
        strongest = math.max(strongest, math.abs(me:force().z - still.z))
        pushed = math.min(pushed, shield:velocity().x)
    end
    me:release("fire")
    wait(0.2)
    shield:place {-15, 0.5, z}
    wait(1)
    return still.y, strongest, pushed
end

local weight, blow, pushed = carry(wizard(1), wizard(2), 16)
local all_weight, all_blow, all_pushed = carry(wizard(2), wizard(1), 16)
expect_near(weight, -0.005 * mass, 0.015, "half the weight is felt")
expect_near(all_weight, -0.01 * mass, 0.015, "the whole weight is felt")
expect_near(pushed, -3 / mass, 0.02, "the impulse of 3 N s reaches the thing")
expect_near(all_pushed, pushed, 0.005, "both things move in the same way")
expect(all_blow > 2 * blow, "the blow: " .. all_blow .. " and without it " .. blow .. " N")
