-- Each of the five potions, brewed in five right ways and in four wrong ones: in the wrong order, too early, too late, and
-- with the wrong force. Ingredients are fetched and dropped in, and gestures are drawn, by the player's own hand.
match {players = {"script", "script"}, set = {"cauldron.brew.cells_across=10", "cauldron.brewing.spoil_harm=0", "cauldron.brewing.niche_again_s=0", "quick.seconds=3600"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
local niches = {ember = {-4.5, 0, 0}, salt = {4.5, 0, 0}, iron = {-7, 0, 0}, resin = {7, 0, 0}, down = {-9.5, 0, 0},
    mist = {9.5, 0, 0}, moss = {12, 0, 0}}
local azoth = {}

-- The orb tells the order of Azoth.
local function scry_the_order()
    me:place {-16.5, 0, 0}
    wait(0.3)
    me:scry(1)
    me:hand_to((me:core()), 0.1)
    wait(1.6)
    me:hand_to({0, 0, 0}, 0.1)
    wait(0.1)
    me:release("stir")
    wait(0.1)
    for i, name in ipairs(expect_event({kind = "recipe_told", by = 1}).ingredients) do azoth[i] = name end
    expect(#azoth == 3, "three ingredients of Azoth are told")
end
wait(1)

-- A circle drawn counterclockwise from its top, 2 wide: the points of its stroke.
local back = {}
for i = 0, 48 do back[i + 1] = {-math.sin(2 * math.pi * i / 48), math.cos(2 * math.pi * i / 48)} end

-- The strokes of each recipe, gentle or hard where it matters: shape, seconds. `wrong`: seconds with the wrong force for
-- the first one. A star may have any force, so a wrong force is one for the gestures before it, or another gesture.
local recipes = {
    haste = {{"ember", "salt"}, {{"circle", 1}, {"circle", 1}, {"circle", 1}}, wrong = 0.3, fault = "hard"},
    ironhide = {{"iron", "resin"}, {{"v", 0.3}, {"v", 0.3}}, wrong = 1, fault = "gentle"},
    feather = {{"down", "mist"}, {{"s", 1}}, wrong = 0.4, fault = "hard"},
    venom = {{"moss", "ember"}, {{"star", 1}}, wrong = "v", fault = "gesture"},
    azoth = {azoth, {{back, 1}, {back, 1}, {back, 1}, {"v", 0.3}, {"star", 1}}, wrong = 0.3, fault = "hard"},
}
local windows = {haste = {{0.5, 0.95}, {0.5, 0.9}}, ironhide = {{0.25, 1}, {0.35, 1}}, feather = {{0.3, 0.85}, {0.3, 0.75}},
    venom = {{0.4, 0.9}, {0.4, 0.75}}, azoth = {{0.6, 1}, {0.6, 1}, {0.6, 1}}}

-- Stirs in circles until the newest ingredient has reached this share of the brew.
local function stir_until(share)
    me:hold("stir")
    for i = 1, 15000 do
        if brew().reached >= share then return end
        local a = 2 * math.pi * i / 800
        me:stroke(math.floor(3 * math.cos(a) + 0.5), math.floor(3 * math.sin(a) + 0.5))
        tick()
    end
    expect(false, "the brew does not mix to " .. share .. ": " .. brew().reached)
end

local function drop(name, rim)
    me:release("stir")
    tick(10)
    me:drop_in(niches[name], rim)
    tick(40)
end

-- Lets an unfinished brew boil over.
local function empty()
    me:release("stir")
    me:place {-15, 0, 0}
    wait_until(function() return #brew().contents == 0 end, 45)
end

-- Drops all ingredients, each one soon after its window has begun: the span of how far the last one has
-- spread. `late`: the share of the window that is waited for.
local function mix(name, late, rim)
    for i, ingredient in ipairs(recipes[name][1]) do
        drop(ingredient, rim)
        local window = windows[name][i]
        local most = math.min(window[2], 0.9)
        stir_until(window[1] + 0.01 + late * (most - window[1]))
    end
end

local function draw(name, size)
    for _, stroke in ipairs(recipes[name][2]) do
        me:cast(stroke[1], {seconds = stroke[2] * (size or 0.07) / 0.07, size = size})
        tick(100)
    end
end

local function brewed(name, way)
    local made, faults = events {kind = "potion", by = 1}, events {kind = "brew_fault", by = 1}
    local last = #faults > 0 and faults[#faults] or {with = "none", time = 0}
    expect(#made > 0 and time() - made[#made].time < 1, string.format("no %s, %s; last fault: %s at %.1f s, reached %.2f",
        name, way, last.with, last.time, brew().reached))
    local event = expect_event {kind = "potion", by = 1}
    expect(event.with == name, way .. " gives " .. event.with .. ", not " .. name)
    tick(40)
    expect(#brew().contents == 0, "the cauldron is empty after " .. name)
end

local function faulty(fault, name, way)
    local event = expect_event {kind = "brew_fault", by = 1, within = 0.2}
    expect(event.with == fault, name .. ", " .. way .. ": " .. event.with .. ", not " .. fault)
end

local west, east = {-2.2, 0, 0}, {2.2, 0, 0}
for _, name in ipairs {"haste", "ironhide", "feather", "venom", "azoth"} do
    if name == "azoth" then scry_the_order() end
    local recipe, window = recipes[name], windows[name]
    -- Right ways: at once, later in the window, from the other side of the rim, small strokes and large ones.
    mix(name, 0, west) draw(name) brewed(name, "at once")
    mix(name, 0.1, west) draw(name) brewed(name, "later")
    mix(name, 0, east) draw(name) brewed(name, "from the east")
    mix(name, 0, west) draw(name, 0.05) brewed(name, "small strokes")
    mix(name, 0, west) draw(name, 0.09) brewed(name, "large strokes")
    if name == "azoth" then expect(me:potions().work_half, "half of the Great Work is held") end
    if name == "haste" then expect(me:potions().haste > 13, "15 s of haste") end

    -- Wrong order: the ingredients the other way round, or one that the recipe lacks.
    drop(recipe[1][2], west)
    stir_until(0.5)
    drop(recipe[1][1], west)
    faulty("order", name, "wrong order")
    empty()
    -- Too early: the second ingredient right after the first.
    drop(recipe[1][1], west)
    drop(recipe[1][2], west)
    faulty("early", name, "early")
    empty()
    -- Too late; or, for a recipe whose windows do not end, the first stroke too soon.
    if window[2][2] < 1 then
        mix(name, 0, west)
        stir_until(window[2][2] + 0.02)
        me:cast(recipe[2][1][1], {seconds = recipe[2][1][2]})
        faulty("late", name, "late")
    else
        for i, ingredient in ipairs(recipe[1]) do
            drop(ingredient, west)
            if i < #recipe[1] then stir_until(window[i][1] + 0.01) end
        end
        me:cast(recipe[2][1][1], {seconds = recipe[2][1][2]})
        faulty("soon", name, "stroke too soon")
    end
    empty()
    -- Wrong force: it costs that stroke only, and the right strokes still brew the potion.
    mix(name, 0, west)
    if type(recipe.wrong) == "string" then
        me:cast(recipe.wrong, {seconds = 0.5})
    else
        me:cast(recipe[2][1][1], {seconds = recipe.wrong})
    end
    faulty(recipe.fault, name, "wrong force")
    tick(100)
    if brew().reached <= window[#recipe[1]][2] then
        draw(name)
        brewed(name, "after a wrong stroke")
    else
        empty()
    end
end
