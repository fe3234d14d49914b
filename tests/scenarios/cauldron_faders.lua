-- Each source of the brew's force on the hand has a fader. Player 1 has only half of the viscosity, player 2
-- all sources but the ladle's mass. Both stir one brew, and both ladles stay in the bowl.
match {
    players = {"script", "script"},
    modes = {
        {viscosity = 50, flow = 0, resistance = 0, surface = 0, wall = 0, inertia = 0, recoil = 0},
        {inertia = 0},
    },
    set = {"haptics.share=1", "cauldron.brew.viscosity_m2_s=0.02", "cauldron.brew.cells_across=16"},
}
clear_props()
local less, all = wizard(1), wizard(2)
local both = {less, all}
less:place {-2.2, 0, 0}
all:place {2.2, 0, 0}
for _, one in ipairs(both) do one:hold("stir") end
trace("faders", {"1.hand_x", "1.force_x", "1.force_y", "2.hand_x", "2.force_x", "2.force_y"})
wait(0.3)

-- Viscosity: a drag coefficient of 4 m in a brew of 1 Pa s, and 0.0067 N at the hand per newton. The player
-- feels one half of that, whatever the brew does.
for i = 1, 200 do
    less:stroke(2, 0)
    tick()
    if i > 50 then
        expect_near(length(less:force()), 0.5 * 0.0067 * 4 * 1 * length(less:ladle_velocity()), 0.002, "half the drag is felt")
    end
end
less:draw(-2, 0, 0.2)
wait(0.3)

-- Flow and resistance: the other player stirs, both let go, and the swirl carries one hand along.
all:draw(0, -2, 0.16)
all:circles(4, 1, 2)
local from = {less:hand(), all:hand()}
local pushed, felt = 0, 0
for _, one in ipairs(both) do one:hold("clutch") end
for i = 1, 400 do
    tick()
    pushed = math.max(pushed, length(less:ladle_force()))
    -- In the first 100 ticks the dry friction may still hold the hand, so they do not count.
    if i > 100 then felt = math.max(felt, length(less:force())) end
end
for _, one in ipairs(both) do one:release("clutch") end
expect(pushed > 1, "the brew pushes a ladle whose hand feels no flow")
expect(felt < 0.005, "force without the flow fader: " .. felt)
expect(distance(less:hand(), from[1]) < 1e-3, "way of the hand without the flow fader: " .. distance(less:hand(), from[1]))
expect(distance(all:hand(), from[2]) > 5e-3, "way of the hand with the flow: " .. distance(all:hand(), from[2]))

-- The wall: both ladles are pressed against it.
local function draw_both(right, up)
    for _ = 1, 300 do
        for _, one in ipairs(both) do one:stroke(right, up) end
        tick()
    end
end
draw_both(3, -1)
wait(0.6)
local middle = brew().middle
for _, one in ipairs(both) do
    local at = one:ladle()
    expect(length {at.x - middle.x, 0, at.z - middle.z} < 1.36, "the ladle stays in the bowl")
end
expect(length(all:force()) > 0.2, "force of the wall: " .. length(all:force()))
expect(length(less:force()) < 0.005, "force of the wall without its fader: " .. length(less:force()))
draw_both(-3, 1)

-- Recoil: each player drops an ingredient into the brew.
local kicks = {0, 0}
for i, one in ipairs(both) do
    one:release("stir")
    wait(0.1)
    one:place {i == 1 and -4.5 or 4.5, 0, 0}
    wait(0.1)
    one:place {i == 1 and -2.2 or 2.2, 0, 0}
    one:hold("stir")
    wait(0.5)
    one:hold("fire")
    for _ = 1, 150 do
        tick()
        kicks[i] = math.max(kicks[i], length(one:force()))
    end
    one:release("fire")
end
expect(#brew().contents == 2, "both players drop an ingredient")
expect(kicks[1] < 0.01, "kick without the recoil fader: " .. kicks[1])
expect(kicks[2] > 0.3, "kick of the recoil: " .. kicks[2])

-- Surface: both ladles come up through it and then press it from above.
local function all_above(height)
    return function() return less:ladle().y > middle.y + height and all:ladle().y > middle.y + height end
end
for _, one in ipairs(both) do one:move(0, 1) end
wait_until(all_above(0.1), 3)
for _, one in ipairs(both) do one:stop() end
wait(0.5)
for _, one in ipairs(both) do one:move(0, -0.35) end
local most, dent = {0, 0}, {0, 0}
wait_until(function()
    for i, one in ipairs(both) do
        most[i] = math.max(most[i], one:force().y)
        dent[i] = math.min(dent[i], surface(one:ladle()) - middle.y)
    end
    return less:ladle().y < middle.y - 0.14 and all:ladle().y < middle.y - 0.14
end, 6)
expect(most[2] > 0.6, "force of the surface: " .. most[2])
expect(most[1] < 0.05, "force without the surface fader, apart from viscosity: " .. most[1])
expect(dent[1] < -0.02 and dent[2] < -0.02, "the surface gives way under both ladles")
for _, one in ipairs(both) do expect(one:created() <= 0.02, "passive forces create no energy") end
