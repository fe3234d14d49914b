-- Ten minutes of fighting with free casting on: a bot that runs, aims, shoots and casts with Trace held, and a mouse that
-- flicks to targets, corrects, tracks and rests. At most one spell is cast without being meant. Then a circle casts.
match {players = {"script", "bot 2"}, seed = 3, free_casting = {true, true},
    set = {"quick.seconds=3600", "quick.kills=1000", "wizard.health.start=900"}}
local state = 1
-- A number from 0 to 1, the same in every run.
local function uniform()
    state = (state * 1103515245 + 12345) % 2147483648
    return state / 2147483648
end
local function noise() return 2 * uniform() - 1 end
local at = {0, 0}
-- A flick, mostly sideways, or the short correction after it: a movement of least jerk with a slight bow.
local function flick(size, up, seconds)
    local from, way, bow = {at[1], at[2]}, {size * noise(), up * size * noise()}, 0.08 * size * noise()
    return seconds, function(share)
        local s = share * share * share * (10 - 15 * share + 6 * share * share)
        return from[1] + s * way[1], from[2] + s * way[2] + bow * math.sin(math.pi * share)
    end
end
-- Follows a target that changes its course.
local function track(seconds)
    local speed, goal, steps = {0, 0}, {0, 0}, 0
    return seconds, function()
        if steps % 20 == 0 then goal = {6 * noise(), 2 * noise()} end
        steps = steps + 1
        for i = 1, 2 do speed[i] = speed[i] + 0.15 * (goal[i] - speed[i]) + 0.2 * noise() end
        return at[1] + speed[1], at[2] + speed[2]
    end
end
local function next_part()
    local kind = uniform()
    if kind < 0.2 then return flick(60 * (0.15 + uniform()), 1, 0.08 + 0.1 * uniform()) end
    if kind < 0.45 then return flick(700 * (0.15 + uniform()), 0.4, 0.12 + 0.3 * uniform()) end
    if kind < 0.65 then return track(0.5 + 2 * uniform()) end
    return 0.05 + 0.5 * uniform(), function() return at[1], at[2] end
end
local me, foe = wizard(1), wizard(2)
local casts, last = {0, 0}, {0, 0}
local function count_casts()
    for player = 1, 2 do
        local cast_at = wizard(player):free_casting().cast_at
        if cast_at ~= last[player] then casts[player] = casts[player] + 1 end
        last[player] = cast_at
    end
end
local right, up = 0, 0
while time() < 600 do
    local seconds, place = next_part()
    local steps = math.max(1, math.floor(seconds / 0.008))
    if uniform() < 0.1 then me:hold("fire") end
    for i = 1, steps do
        at[1], at[2] = place(i / steps)
        local to_right, to_up = math.floor(at[1] + 0.5), math.floor(at[2] + 0.5)
        me:draw(to_right - right, to_up - up, 0.001)
        wait(0.007)
        right, up = to_right, to_up
    end
    me:release("fire")
    count_casts()
end
expect(me:shots() > 20 and foe:shots() > 100, "both fight")
expect(casts[1] + casts[2] <= 1, casts[1] .. " casts of the mouse, " .. casts[2] .. " of the bot")
-- Draws a circle, and says whether its wizard was alive all the while.
local function draw_circle()
    while me:dead() do wait(0.1) end
    local deaths = me:deaths()
    wait(1)
    for i = 1, 90 do
        local a, b = 2 * math.pi * (i - 1) / 90, 2 * math.pi * i / 90
        local function counts(v) return math.floor(350 * v + 0.5) end
        me:draw(counts(math.sin(b)) - counts(math.sin(a)), counts(math.cos(b)) - counts(math.cos(a)), 0.001)
        wait(0.007)
    end
    wait(0.5)
    return not me:dead() and me:deaths() == deaths
end
while not draw_circle() do end
expect(me:free_casting().cast_at > last[1], "a circle casts all the same")
