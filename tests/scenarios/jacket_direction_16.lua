-- A bolt from each of 16 directions is felt on its side of a jacket, and not at all on the far one. The
-- caption names the side whose cells are on.
match {players = {"script", "script"}, set = {"bolt.shot.damage=1"}}
clear_props()
senses {layouts = {"x40", "x16"}}
local me, foe = wizard(1), wizard(2)
local home = {-14, 0, 11}

-- Sum of the squares of what is felt, and its mean direction (x: right, z: front).
local function felt_on(layout)
    local energy, x, z = 0, 0, 0
    for _, cell in ipairs(body(1, layout)) do
        local e = cell.felt * cell.felt
        energy, x, z = energy + e, x + e * cell.at.x, z + e * cell.at.z
    end
    return energy, x, z
end

local function far_side_is_silent(layout, right, front)
    for i, cell in ipairs(body(1, layout)) do
        local out = math.max(math.sqrt(cell.at.x * cell.at.x + cell.at.z * cell.at.z), 1e-9)
        local towards = (cell.at.x * right + cell.at.z * front) / out
        if towards < -0.5 then expect(cell.felt < 0.02, layout .. ", cell " .. i .. " on the far side") end
    end
end

local sides = {"ahead", "right", "behind", "left"}
for i = 0, 15 do
    local angle = i * 2 * math.pi / 16 -- from straight ahead, to the right
    me:place(home)
    me:face(0) -- looks along -z
    local right, front = math.sin(angle), math.cos(angle)
    foe:place {home[1] + 3 * right, home[2], home[3] - 3 * front}
    wait(0.3)
    foe:aim(me)
    local before = #events {kind = "bolt_hit", subject = 1}
    foe:press("fire")
    wait_until(function() return #events {kind = "bolt_hit", subject = 1} > before end, 2)
    wait(0.016)
    for _, layout in ipairs {"abstract_4x5", "x40", "x16"} do
        local energy, x, z = felt_on(layout)
        expect(energy > 0.01, layout .. ": the hit " .. i .. " is felt")
        if math.abs(front) > 0.1 then expect(z * front > 0, layout .. ": front or back, " .. i) end
        if math.abs(right) > 0.1 then expect(x * right > 0, layout .. ": left or right, " .. i) end
        far_side_is_silent(layout, right, front)
    end
    if i % 4 == 0 then
        local told
        for _, line in ipairs(heard(1)) do told = told or (line.words == "hit" and line.side == sides[1 + i // 4]) end
        expect(told, "the words tell the side: " .. sides[1 + i // 4])
    end
    wait(0.4)
    expect(felt_on("x40") == 0, "the hit " .. i .. " is over")
end
