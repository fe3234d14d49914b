-- The words on the screen say from the first second how far the newest ingredient has spread, and stirring raises the
-- number all the time, also while the mixing number of recipes is still 0.
match {players = {"script", "script"}}
clear_props()
local me = wizard(1)
local function shown()
    for percent = 0, 100 do
        if on_screen("mixed " .. percent .. " %") then return percent end
    end
end
me:drop_in({-4.5, 0, 0}, {-2.2, 0, 0})
me:circles(0.5, 0.8, 2)
local before = shown()
expect(before and before > 0, "a number after half a second: " .. tostring(before))
for second = 1, 4 do
    me:circles(1, 0.8, 2)
    if second == 1 then expect(brew().mixing == 0, "the mixing number is still 0") end
    local now = shown()
    expect(now > before, "second " .. second .. ": " .. now .. " after " .. before)
    before = now
end
