-- The lift's spring has 4,000 N/m in the world and 300 N/m at the hand for a thing of one metre. A thing that
-- hangs still is felt only by the weight's fader, 0.01 N/kg. A thing that the hand moves is felt by its
-- inertia: a heavier thing pulls harder and longer.
match {players = {"script", "script"}, set = {"haptics.share=1"}}
clear_props()
trace("heavy", {"1.force_x", "1.force_y", "1.hand_x", "1.energy"})
local me = wizard(1)
wizard(2):place {-15, 0, -15}
me:press("wand_4")

local function carry(mass)
    me:place {8, 0, 16}
    me:face(-90, 0)
    local thing = spawn {kind = "box", size = {1, 1, 1}, mass = mass, at = {11, 0.5, 16}}
    wait(0.2)
    me:aim(thing)
    wait(0.1)
    me:hold("fire")
    wait(0.1)
    me:look(0, 15)
    wait(2)
    expect(thing:position().y > 0.8, "the thing hangs in the air")
    expect_near(me:force().y, -0.01 * mass, 0.01, "weight felt through the fader")
    expect_near(length(me:force()), 0.01 * mass, 0.015, "no other force")
    local from, impulse, greatest = thing:position().z, 0, 0
    me:hold("clutch")
    me:look(5, 0)  -- 100 counts move the hand 10 mm to the right: 0.2 m in the world, along +z
    local last = time() + 2
    while time() < last do
        tick()
        impulse = impulse - me:force().x * 0.001
        greatest = math.max(greatest, -me:force().x)
    end
    expect_near(thing:position().z - from, 20 * me:hand().x, 0.02, "the thing follows the hand at 20 to 1")
    me:look(-5, 0)
    wait(2)
    me:release("clutch")
    me:release("fire")
    wait(0.1)
    thing:place {-15, 0.5, 16}
    wait(0.3)
    return impulse, greatest
end

local light, light_peak = carry(5)
local heavy, heavy_peak = carry(40)
expect(heavy > 2 * light, "the heavier thing pulls back for longer")
log("impulse N s", light, heavy, "peak N", light_peak, heavy_peak)
expect(me:created() <= 0.02, "the spring creates no energy")
