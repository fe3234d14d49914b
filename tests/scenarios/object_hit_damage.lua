-- A thing that hits with an impulse of J N s costs 0.12 (J - 60) HP, at most 60 HP, and not again within 0.4
-- s. J is measured as the thing's loss of momentum during the blow. J itself is checked too. A plastic
-- collision of m and M gives m M / (m + M) v. The wizard's braking legs (at most 40 m/s^2) push the thing on
-- during the blow.
match {players = {"script", "script"}}
clear_props()

local me, mass = wizard(1), 75
local blow = 24  -- ticks over which a blow is summed
local home = {-14, 0, 9}

-- Throws a ball level at the chest. Returns the impulse, the lost HP, and the range that mechanics allows.
local function throw(ball, m, v)
    ball:place({-12, 1.1, 9}, {-v, 0, 0})
    local health, last = me:health(), -v
    wait_until(function()
        if ball:velocity().x > last + 0.05 then return true end
        last = ball:velocity().x
        return false
    end, 2)
    tick(blow - 1)
    local impulse = m * (ball:velocity().x - last)
    tick(16)
    local plastic = m * mass / (m + mass) * v
    return impulse, health - me:health(), plastic, plastic + m * 40 * blow / 1000
end

local function ready()
    wait(0.5)
    me:place(home)
    me:face(-90)
    wait(0.2)
end

for _, case in ipairs {{4, 10}, {5, 12}, {10, 8}, {10, 12}, {20, 10}, {30, 12}} do
    local m, v = case[1], case[2]
    local ball = spawn {kind = "sphere", radius = 0.2, mass = m, at = {-5, 1, 14}}
    ready()
    if me:health() < 62 then
        me:place {-14, 70, 9}
        wait_until(function() return me:dead() end, 6)
        wait(5)
        ready()
    end
    local impulse, lost, least, most = throw(ball, m, v)
    local what = m .. " kg at " .. v .. " m/s"
    expect(impulse > 0.99 * least and impulse < most, what .. ": an impulse of " .. impulse)
    expect_near(lost, math.max(0, math.min(60, 0.12 * (impulse - 60))), 0.02, what)
    ball:place {10, 3, 14}
end

-- A blow costs at most 60 HP.
ready()
wait_until(function() return me:grounded() end, 1)
me:place {-14, 70, 9}
wait_until(function() return me:dead() end, 6)
wait(5)
local stone = spawn {kind = "sphere", radius = 0.3, mass = 120, at = {-5, 3, 14}}
ready()
local impulse, lost = throw(stone, 120, 20)
expect(impulse > 560, "an impulse of " .. impulse)
expect_near(lost, 60, 0, "largest damage of a blow")
stone:place {10, 3, 14}

-- Two blows of one thing within 0.4 s count once. A later blow counts again.
local hits = #events("object_hit")
local ball = spawn {kind = "sphere", radius = 0.2, mass = 8, at = {-5, 3, 14}}
local function throw_again()
    me:place(home)
    ball:place({-13.3, 1.1, 9}, {-12, 0, 0})
end
ready()
throw_again()
wait(0.2)
expect_near(#events("object_hit") - hits, 1, 0, "hits after the first blow")
throw_again()
wait(0.15)
expect_near(#events("object_hit") - hits, 1, 0, "hits after a blow 0.2 s later")
wait(0.2)
throw_again()
wait(0.2)
expect_near(#events("object_hit") - hits, 2, 0, "hits after a blow 0.55 s later")
ball:place {10, 3, 12}

-- A wizard who walks into a standing thing is not hurt.
local crate = spawn {kind = "box", size = {1, 1, 1}, mass = 120, at = {-11, 0.5, 9}}
ready()
local health = me:health()
me:move(0, 1)
wait(2)
me:stop()
expect(me:position().x > -13, "the wizard walks up to the crate")
expect_near(me:health(), health, 0, "walking into a crate does no harm")
