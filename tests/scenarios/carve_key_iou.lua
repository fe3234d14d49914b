-- A wizard carves a crystal into the key of its ghost with mouse and keys, while a bot shoots: the hand goes from one
-- wrong voxel to the next, melts and builds, first from the front and then from behind. Shots chip the work, and death
-- interrupts it. At an overlap of 0.8 the wizard holds the Lens, and the crystal is rough again.
match {players = {"script", "bot 1"}, seed = 8, set = {"quick.kills=9"}}
local me = wizard(1)
local middle, voxel = crystal(1).middle, crystal(1).voxel
-- Hand's scale (world per device), distance before the crystal's middle (m, world), reach (m, device)
local scale, front, reach = 5.5, 0.1, {x = 0.08, y = 0.06, z = 0.035}
local home, side

local function within(v, most) return math.max(-most, math.min(most, v)) end

-- Place of the hand in its device that puts the tool at a place of the world.
local function hand_for(p)
    return {x = -side * (p.x - middle.x) / scale, y = (p.y - middle.y) / scale,
            z = (-side * (p.z - middle.z) - front) / scale}
end

-- Moves the mouse and presses forward keys for one tick, so that the hand goes towards a place.
local function steer(to)
    local function counts(axis)
        return math.floor(within((within(to[axis], reach[axis]) - home[axis]) / 1e-4, 2) + 0.5)
    end
    local right, up = counts("x"), counts("y")
    local back = within(to.z, reach.z) - home.z
    local ahead = back > 1.2e-4 and -1 or back < -1.2e-4 and 1 or 0
    me:stroke(right, up)
    me:move(0, ahead)
    wait(0.001)
    home = {x = within(home.x + 1e-4 * right, reach.x), y = within(home.y + 1e-4 * up, reach.y),
            z = within(home.z - 1e-4 * ahead, reach.z)}
end

local function begin()
    while me:dead() do wait(0.1) end
    me:place {middle.x, 0, middle.z - 1.5 * side}
    me:hold("stir")
    wait(0.1)
    home = me:hand()
end

local dice = 1
local function random(most)
    dice = dice * 48271 % 2147483647
    return (dice / 2147483647 * 2 - 1) * most
end

-- Works with one tool until nothing is left that it reaches.
local function carve(kind, limit)
    local last, misses, since, best, from, tool = time() + limit, 0, time()
    while time() < last and misses < 12 and not carver(1).lens do
        if me:dead() or not carver(1).place then
            me:release("fire")
            begin()
            tool = nil
        end
        if not tool then me:press(kind == "melt" and "wand_1" or "wand_2") tool = kind end
        local here = carver(1).place or middle
        local fault = crystal_fault(1, from or here, kind)
        if not fault then break end
        if not best or distance(fault, best) > 0.02 then best, since = fault, time() end
        if time() > since + 0.8 then
            misses, best = misses + 1, nil
            from = {middle.x + random(0.25), middle.y + random(0.15), middle.z - 0.05 * side}
        elseif from and distance(here, fault) < 0.03 then
            from = nil
        end
        local to = hand_for(fault)
        if kind == "melt" then to.z = to.z - 0.003 end
        if math.abs(to.x - home.x) > 0.006 or math.abs(to.y - home.y) > 0.006 then to.z = math.max(to.z, 0.01) end
        for _ = 1, 8 do steer(to) end
        local near = carver(1).place and distance(carver(1).place, fault) < 2.6 * voxel
        if near then me:hold("fire") else me:release("fire") end
    end
    me:release("fire")
end

local rough
for round = 1, 4 do
    if carver(1).lens then break end
    side = round % 2 == 1 and 1 or -1
    begin()
    rough = rough or crystal(1)
    carve("melt", 15)
    carve("construct", 8)
    me:release("stir")
    me:stop()
    wait(0.1)
end
expect(rough.overlap > 0.4 and rough.overlap < 0.65, "overlap of the rough body: " .. rough.overlap)
expect(carver(1).lens, "the Lens is held; overlap " .. crystal(1).overlap)
expect(#events {kind = "lens", by = 1} == 1, "it was told")
expect(crystal(1).seed ~= rough.seed and crystal(1).overlap < 0.65, "the crystal is rough again, for another key")
expect(me:created() < 0.02, "the hand was given no energy: " .. me:created() .. " J")
expect(#events {kind = "chipped"} > 0, "the bot has chipped the work")
