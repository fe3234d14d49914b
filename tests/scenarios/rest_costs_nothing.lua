-- An untouched brew stays asleep. A stirred brew falls asleep again, and its state then stays constant.
match {players = {"script", "script"}, set = {"cauldron.brew.viscosity_m2_s=0.2", "cauldron.surface.damping_per_s=20"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
me:place {-2.2, 0, 0}
wait(1)
expect(brew().asleep, "an untouched brew is asleep")
me:hold("stir")
wait(0.2)
me:draw(2, 0, 0.2)
wait(0.2)
expect(not brew().asleep, "a stirred brew is awake")
me:release("stir")
wait_until(function() return brew().asleep end, 30)
expect(brew().speed == 0, "a sleeping brew does not move")
