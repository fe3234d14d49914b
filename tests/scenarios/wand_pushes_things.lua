-- The wand's tip pushes a thing as hard as the hand feels it: 1 N at the hand is 50 N on the thing.
match {players = {"script", "script"}}
clear_props()
local me = wizard(1)
me:place {-10, 0, 0}
me:face(0)
wait(0.5)
local newtons = 50

-- A plate flies slowly against the tip from the right. The hand receives exactly the momentum that the plate
-- loses, and the plate turns back.
local plate = spawn {kind = "box", size = {0.4, 1.6, 0.8}, mass = 5, at = {-9.53, 1.6, -0.75}, velocity = {-0.4, 2, 0}}
local before, hand, most, last = plate:velocity().x, 0, 0, 0
trace("plate", {"1.hand_x", "1.force_x", "t1.speed"})
for _ = 1, 450 do
    local speed = plate:velocity().x
    tick()
    last = me:force().x
    hand = hand + last * 0.001
    most = math.max(most, -last)
end
expect(most > 0.3 and most < 1.4, "felt, and below the cap: " .. most .. " N")
expect_near(5 * (plate:velocity().x - before), -newtons * hand, 1e-9, "equal and opposite")
expect(plate:velocity().x > 0.03, "pushed away again: " .. plate:velocity().x .. " m/s")
plate:place {14, 3, 12}

-- A push with the hand: 3 cm at the hand is 0.3 m at the tip. The light crate moves away, the stone does not.
local function push(mass)
    local crate = spawn {kind = "box", size = {1.6, 1.6, 1.2}, mass = mass, at = {-8.85, 0.8, -0.75}}
    wait(0.4)
    local from = crate:position().x
    me:hold("clutch")
    me:look(30, 0)
    me:release("clutch")
    local felt = 0
    for _ = 1, 500 do
        tick()
        felt = math.max(felt, -me:force().x)
    end
    local moved = crate:position().x - from
    me:hold("clutch")
    me:look(-30, 0)
    me:release("clutch")
    crate:place {14, 3, mass / 10}
    wait(0.5)
    return moved, felt
end

local light, light_felt = push(8)
local heavy, heavy_felt = push(120)
expect(light > 0.02, "8 kg moved " .. light .. " m")
expect(math.abs(heavy) < 0.01, "120 kg moved " .. heavy .. " m")
expect(heavy_felt > light_felt and light_felt > 0.2, "the heavy one is felt more: " .. heavy_felt .. " and " .. light_felt .. " N")

-- A pushed thing's blow is credited to the player who pushed it. If a victim's wand touches a thing that the
-- other player has thrown, the blow is still credited to the thrower.
local foe = wizard(2)
foe:place {-10, 0, -6}
foe:face(180)
local thrown = spawn {kind = "box", size = {0.4, 1.6, 0.4}, mass = 10, at = {-9.6, 0.9, -4}, velocity = {0, 0, 0}}
foe:press("wand_4")
wait(0.2)
foe:aim(thrown)
wait(0.1)
foe:hold("fire")
wait(0.5)
foe:aim(me)
wait(0.7)
foe:press("throw")
expect_event {kind = "object_hit", subject = 1, by = 2, within = 1.5}
