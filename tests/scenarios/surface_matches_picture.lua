-- The surface that stops the hand is the one that the picture shows: a hand that presses into the crystal comes to rest
-- within half a voxel of where a ray along the same line meets the drawn surface. So it does again where the crystal was
-- carved.
match {players = {"script", "script"}, seed = 11}
local me = wizard(1)
local middle, voxel = crystal(1).middle, crystal(1).voxel
me:place {middle.x, 0, middle.z - 1.5}
me:hold("stir")
wait(0.1)

-- Presses the hand in from the front at a place across the view (m, world), until it rests. Returns how far the
-- surface is from the picture's (voxels), or nil where the hand meets nothing.
local function press(x, y)
    me:move(0, -1)
    wait(0.9)
    me:stop()
    for _ = 1, 400 do
        local here = me:hand()
        local right, up = -(x - middle.x) / 5.5 - here.x, (y - middle.y) / 5.5 - here.y
        me:stroke(math.floor(right / 1e-4 / 8 + 0.5), math.floor(up / 1e-4 / 8 + 0.5))
        wait(0.004)
    end
    me:move(0, 1)
    local force = 0
    for _ = 1, 600 do
        wait(0.001)
        force = length(me:force())
        if force > 0.5 then break end
    end
    me:stop()
    wait(0.4)
    if length(me:force()) < 0.2 then return nil end
    local at = carver(1).place
    local seen = crystal_ray(1, {at.x, at.y, middle.z - 0.6}, {0, 0, 1})
    -- The hand may have slid into a groove, where a ray along the view misses its place. So a ray along the
    -- force counts, too.
    local push = carver(1).force
    local along = crystal_ray(1, {at.x + push.x * 0.05, at.y + push.y * 0.05, at.z + push.z * 0.05}, {-push.x, -push.y, -push.z})
    return math.min(seen and distance(seen, at) / voxel or 99, along and distance(along, at) / voxel or 99)
end

local pressed, worst = 0, 0
local function press_all()
    for _, place in ipairs {{0.02, 0}, {-0.05, 0.01}, {0.1, 0.02}, {0.16, 0.06}, {0.16, -0.08}, {-0.13, -0.02}} do
        local off = press(middle.x + place[1], middle.y + place[2])
        if off then
            pressed = pressed + 1
            worst = math.max(worst, off)
        end
    end
end
press_all()
expect(pressed >= 3, "the hand was stopped " .. pressed .. " times")
expect(worst <= 0.5, "off by " .. worst .. " voxels")
local smooth = crystal(1).hash
me:move(0, 1)
me:hold("fire")
me:draw(1, 0, 0.3)
me:release("fire")
me:stop()
expect(crystal(1).hash ~= smooth, "the crystal was carved")
pressed, worst = 0, 0
press_all()
expect(pressed >= 3, "the hand was stopped " .. pressed .. " times after carving")
expect(worst <= 0.5, "off by " .. worst .. " voxels after carving")
