-- Both players see the match, each in one half, for either direction of the split.
match {players = {"script", "script"}}
wizard(2):look(25, 5)
wait(0.2)

local halves = {
    side_by_side = {{0, 0, 0.49, 1}, {0.51, 0, 1, 1}},
    top_bottom = {{0, 0, 1, 0.49}, {0, 0.51, 1, 1}},
}

local function difference(a, b)
    local sum = 0
    for i = 1, 3 do sum = sum + math.abs(a[i] - b[i]) end
    return sum
end

-- Mean colours of a 6 x 6 grid of fields in a part of the picture.
local function grid(view, part)
    local x0, y0, x1, y1 = table.unpack(part)
    local means = {}
    for row = 0, 5 do
        for column = 0, 5 do
            local x, y = x0 + (x1 - x0) * column / 6, y0 + (y1 - y0) * row / 6
            means[#means + 1] = {view:mean(x, y, x + (x1 - x0) / 6.1, y + (y1 - y0) / 6.1)}
        end
    end
    return means
end

local function total(a, b)
    local sum = 0
    for i = 1, #a do sum = sum + difference(a[i], b[i]) end
    return sum / #a
end

for _, split in ipairs {"side_by_side", "top_bottom"} do
    local first, second = halves[split][1], halves[split][2]
    local before = picture {split = split, name = split}
    for i, half in ipairs {first, second} do
        expect(before:colours(table.unpack(half)) > 50, split .. ": half " .. i .. " is no plain colour")
    end
    expect(total(grid(before, first), grid(before, second)) > 3, split .. ": each half has its own view")

    -- Only the view of the player who turns changes.
    wizard(1):look(70, 0)
    wait(0.1)
    local turned = picture {split = split, name = split .. "_turned"}
    local mine = total(grid(before, first), grid(turned, first))
    local other = total(grid(before, second), grid(turned, second))
    expect(mine > 3, split .. ": player 1 turned, and the first half shows it")
    expect(other < mine / 4, split .. ": the second half is unchanged")
    wizard(2):look(-90, 0)
    wait(0.1)
    local both = picture {split = split}
    local theirs = total(grid(turned, second), grid(both, second))
    expect(theirs > 3, split .. ": player 2 turned, and the second half shows it")
end
