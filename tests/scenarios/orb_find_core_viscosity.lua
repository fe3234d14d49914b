-- The viscosity mode is thick where the flow turns fast. The core is the middle of the thick place along every way.
match {players = {"script", "script"}, seed = 3}
local s = seeker(1, 1)

-- How thick it is on the way from one place to another: a list of {at = , thick = in N}.
local function sweep(from, to)
    s:go(from)
    local list, mean = {}, 0
    for i = 1, 3000 do
        local left = s.wizard:steer(to, 0.06)
        mean = mean + 0.05 * (length(s.wizard:force()) - mean)
        if i > 30 then list[#list + 1] = {at = s.wizard:hand(), thick = mean} end
        if left < 1e-6 or s:told() then break end
    end
    return list
end

-- The middle of the longest thick stretch; nil if there is none.
local function middle_of_thick(list)
    local most, best, first = 0, nil, nil
    for _, place in ipairs(list) do most = math.max(most, place.thick) end
    if most < 0.25 then return nil end
    for i, place in ipairs(list) do
        local thick = place.thick > 0.75 * most
        first = first or thick and i or nil
        if first and (not thick or i == #list) then
            if not best or i - first > best.count then
                best = {count = i - first, at = plus(list[first].at, plus(place.at, list[first].at, -1), 0.5)}
            end
            first = nil
        end
    end
    return best.at
end

local axes, reach = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0.05, 0.05, 0.032}

-- Goes to the middle along y, z and x in turn, twice.
local function refined(at)
    for turn = 1, 6 do
        local number = turn % 3 + 1
        local axis = axes[number]
        local here = dot(at, axis)
        local low, high = math.max(-reach[number], here - 0.022), math.min(reach[number], here + 0.022)
        local middle = middle_of_thick(sweep(plus(at, axis, low - here), plus(at, axis, high - here)))
        if s:told() then return at end
        if middle then at = plus(at, axis, dot(middle, axis) - here) end
    end
    return at
end

for _, y in ipairs {0, 0.015, -0.015, 0.03, -0.03} do
    for _, z in ipairs {0, 0.015, -0.015} do
        local middle = not s:told() and middle_of_thick(sweep({-0.04, y, z}, {0.04, y, z}))
        if middle and not s:told() then s:wait_at(refined(middle)) end
    end
end
s:expect_found("thick places led the hand to the core")
