#include "game/scenario/detail/prelude.h"

namespace thaum::game::inline scenario {

// Errors in prelude functions are reported at the script's line that called them, so all checks use fail().
// The names that begin with raw_ are removed before a script starts.
const std::string_view prelude = R"lua(
local raw = {}
for _, name in ipairs {
    "wait", "match", "button", "trigger", "fader", "move", "look", "counts_to", "counts_of", "read", "place", "face", "spawn", "thing_there",
    "thing_position", "thing_velocity", "thing_place", "thing_push", "next_event", "picture", "picture_mean",
    "picture_colours", "reach", "told", "stall", "stick", "draw", "scrying", "core", "curve",
} do
    raw[name] = _G["raw_" .. name]
    _G["raw_" .. name] = nil
end
local fail, now, type, tostring, setmetatable, sqrt = fail, now, type, tostring, setmetatable, math.sqrt
local floor, max, min, abs = math.floor, math.max, math.min, math.abs
local pi, cos, sin = math.pi, math.cos, math.sin
log = print

-- time ---------------------------------------------------------------------------------------------------------------

local function need_number(value, name)
    if type(value) ~= "number" then fail(name .. " must be a number, not " .. type(value)) end
    return value
end

local function ticks_of(seconds)
    return floor(need_number(seconds, "seconds") * 1000 + 0.5)
end

function wait(seconds) raw.wait(ticks_of(seconds)) end

function tick(count) raw.wait(count == nil and 1 or count) end

function time() return (raw.match()) end

function paused() local _, is_paused = raw.match() return is_paused end

function round_over()
    local _, _, over, ending, winner = raw.match()
    return over, ending, winner
end

function match_over()
    local _, _, _, _, _, over, _, first, second = raw.match()
    return over, {first, second}
end

function round_number() return (select(7, raw.match())) end

function wait_until(condition, limit)
    if type(condition) ~= "function" then fail("wait_until takes a function") end
    local last = now() + ticks_of(limit)
    while not condition() do
        if now() >= last then fail("not within " .. limit .. " s") end
        raw.wait(1)
    end
end

-- expectations -------------------------------------------------------------------------------------------------------

local function with(message) return message == nil and "" or ": " .. tostring(message) end

function expect(condition, message)
    if not condition then fail("expected otherwise" .. with(message)) end
    return condition
end

function expect_near(value, wanted, tolerance, message)
    need_number(value, "the value") need_number(wanted, "the wanted value") need_number(tolerance, "the tolerance")
    if not (abs(value - wanted) <= tolerance) then
        fail(string.format("%.6g is not %.6g within %.3g", value, wanted, tolerance) .. with(message))
    end
end

function expect_event(wish)
    local limit = type(wish) == "table" and wish.within or 0
    local last = now() + ticks_of(limit)
    local event = raw.next_event(wish)
    while not event do
        if now() >= last then fail("no such event within " .. limit .. " s: " .. tostring(wish.kind)) end
        raw.wait(1)
        event = raw.next_event(wish)
    end
    return event
end

-- places -------------------------------------------------------------------------------------------------------------

local function coordinates(p)
    if type(p) ~= "table" then fail("a place must be {x, y, z}, not " .. type(p)) end
    local x, y, z = p.x or p[1], p.y or p[2], p.z or p[3]
    return need_number(x, "x"), need_number(y, "y"), need_number(z, "z")
end

function length(v)
    local x, y, z = coordinates(v)
    return sqrt(x * x + y * y + z * z)
end

function distance(a, b)
    local ax, ay, az = coordinates(a)
    local bx, by, bz = coordinates(b)
    return length {ax - bx, ay - by, az - bz}
end

-- a + share b; without a share, a + b.
function plus(a, b, share)
    local ax, ay, az = coordinates(a)
    local bx, by, bz = coordinates(b)
    share = share or 1
    return {x = ax + share * bx, y = ay + share * by, z = az + share * bz}
end

function dot(a, b)
    local ax, ay, az = coordinates(a)
    local bx, by, bz = coordinates(b)
    return ax * bx + ay * by + az * bz
end

-- The direction of a way; {x = 1, y = 0, z = 0} if it has no length.
function unit(a)
    local x, y, z = coordinates(a)
    local size = sqrt(x * x + y * y + z * z)
    if size < 1e-12 then return {x = 1, y = 0, z = 0} end
    return {x = x / size, y = y / size, z = z / size}
end

-- wizards ------------------------------------------------------------------------------------------------------------

local Wizard, Thing = {}, {}
Wizard.__index, Thing.__index = Wizard, Thing

function wizard(n)
    if n ~= 1 and n ~= 2 then fail("there are wizard(1) and wizard(2)") end
    return setmetatable({player = n}, Wizard)
end

for _, name in ipairs {
    "position", "centre", "eye", "velocity", "yaw", "pitch", "health", "energy", "readiness", "shots", "kills",
    "deaths", "dead", "grounded", "shielded", "focus", "ward", "hand", "force", "force_cause", "created",
    "reading", "free_casting", "potions", "stirs", "ladle", "ladle_velocity", "ladle_force",
} do
    Wizard[name] = function(self) return raw.read(self.player, name) end
end

function Wizard:hold(button) raw.button(self.player, button, true) end

function Wizard:release(button) raw.button(self.player, button, false) end

-- How far fire is pulled while it is held.
function Wizard:trigger(share) raw.trigger(self.player, share) end

-- Moves a fader of the player's hand in the coming tick: force, weight, blows, recoil, roughness, brew flow, ...
function Wizard:fader(name, percent) raw.fader(self.player, name, percent) end

-- A player's press: two gameplay ticks and a half, and one tick in which the button is up.
function Wizard:press(button, seconds)
    raw.button(self.player, button, true)
    raw.wait(max(1, ticks_of(seconds or 0.02)))
    raw.button(self.player, button, false)
    raw.wait(1)
end

function Wizard:move(strafe, forward) raw.move(self.player, strafe, forward) end

function Wizard:stop() raw.move(self.player, 0, 0) end

-- The mouse's counts in the coming tick.
function Wizard:stroke(right, up) raw.look(self.player, right, up) end

-- So many in each tick for a while.
function Wizard:draw(right, up, seconds)
    for _ = 1, ticks_of(seconds) do
        raw.look(self.player, right, up)
        raw.wait(1)
    end
end

function Wizard:look(right, up)
    local counts_right, counts_up = raw.counts_of(self.player, right), raw.counts_of(self.player, up or 0)
    raw.look(self.player, counts_right, counts_up)
    raw.wait(1 + max(abs(counts_right), abs(counts_up)) // 8)
end

-- The mouse goes round, once in `period` seconds, `counts` a tick: to the right and then away; sense -1: to the left and then
-- away. After each tick each(i) is called, where it is given.
function Wizard:circles(seconds, period, counts, sense, each)
    for i = 1, ticks_of(seconds) do
        local a = 2 * pi * i / (1000 * period)
        raw.look(self.player, floor((sense or 1) * counts * cos(a) + 0.5), floor(counts * sin(a) + 0.5))
        raw.wait(1)
        if each then each(i) end
    end
end

-- Corners or points of the shapes of :cast, 2 wide.
local shapes = {v = {{-0.7, 1}, {0, -1}, {0.7, 1}}, circle = {}, star = {}, s = {}}
for i = 0, 48 do
    shapes.circle[i + 1] = {sin(2 * pi * i / 48), cos(2 * pi * i / 48)}
    local a = pi / 180 * (i <= 24 and 30 + 10 * i or 90 - 10 * (i - 24))
    shapes.s[i + 1] = {0.6 * cos(a), (i <= 24 and 0.5 or -0.5) + 0.5 * sin(a)}
end
for i = 0, 5 do shapes.star[i + 1] = {sin(4 * pi * (i + 0.5) / 5), cos(4 * pi * (i + 0.5) / 5)} end

-- Moves the mouse along a list of places, so many metres of the hand for each unit.
local function draw_along(self, points, scale, seconds)
    local length = 0
    for i = 2, #points do
        length = length + sqrt((points[i][1] - points[i - 1][1]) ^ 2 + (points[i][2] - points[i - 1][2]) ^ 2)
    end
    local per_metre, right, up = 1e4, 0, 0
    for i = 2, #points do
        local from, to = points[i - 1], points[i]
        local way = sqrt((to[1] - from[1]) ^ 2 + (to[2] - from[2]) ^ 2)
        local steps = max(1, floor(1000 * seconds * way / length + 0.5))
        for k = 1, steps do
            local x = per_metre * scale * (from[1] + (to[1] - from[1]) * k / steps - points[1][1])
            local y = per_metre * scale * (from[2] + (to[2] - from[2]) * k / steps - points[1][2])
            local next_right, next_up = floor(x + 0.5), floor(y + 0.5)
            raw.draw(self.player, next_right - right, next_up - up)
            right, up = next_right, next_up
            raw.wait(1)
        end
    end
end

-- Draws "circle", "v", "s" or "star" with Trace held: {size = width in metres, seconds, times = turns in one stroke}. Any
-- other shape is a list of places like those of `shapes`.
function Wizard:cast(shape, how)
    how = how or {}
    local points = shapes[shape] or shape
    local all = {}
    for _ = 1, how.times or 1 do
        for i = 1, #points do all[#all + 1] = points[i] end
    end
    raw.button(self.player, "trace", true)
    raw.wait(10)
    draw_along(self, all, (how.size or 0.07) / 2, (how.seconds or 1) * (how.times or 1))
    raw.wait(20)
    raw.button(self.player, "trace", false)
    raw.wait(10)
end

-- Draws a list of {t = s, x = m, y = m} with Trace held, as far as a mouse can: in steps of 0.1 mm.
function Wizard:trace_over(points)
    raw.button(self.player, "trace", true)
    raw.wait(10)
    local next, right, up, last = 1, 0, 0, points[#points]
    for tick = 1, floor(1000 * last.t) + 1 do
        local t = tick / 1000
        while next < #points and points[next].t < t do next = next + 1 end
        local a, b = points[max(1, next - 1)], points[next]
        local share = b.t > a.t and max(0, min(1, (t - a.t) / (b.t - a.t))) or 1
        local x = floor(1e4 * (a.x + (b.x - a.x) * share - points[1].x) + 0.5)
        local y = floor(1e4 * (a.y + (b.y - a.y) * share - points[1].y) + 0.5)
        raw.draw(self.player, x - right, y - up)
        right, up = x, y
        raw.wait(1)
    end
    raw.wait(20)
    raw.button(self.player, "trace", false)
    raw.wait(10)
end

-- Deflects the stick that turns the view, each part in -1..1, until it is changed.
function Wizard:stick(right, up) raw.stick(self.player, right, up) end

-- A key chord: the key of a wand while Trace is held, with fire for a harsh one.
function Wizard:chord(slot, harsh)
    raw.button(self.player, "trace", true)
    raw.wait(24)
    if harsh then raw.button(self.player, "fire", true) end
    raw.wait(8)
    raw.button(self.player, "wand_" .. slot, true)
    raw.wait(24)
    raw.button(self.player, "wand_" .. slot, false)
    if harsh then raw.button(self.player, "fire", false) end
    raw.wait(8)
    raw.button(self.player, "trace", false)
    raw.wait(16)
end

-- A wizard at the orb or at a crystal moves the hand for a tick towards a place (m, device frame), at most so many m/s, in
-- the steps of a mouse and of the keys for walking: 0.1 mm. Returns the distance that is left to the place.
function Wizard:steer(place, speed)
    local x, y, z = coordinates(place)
    local home = self.home
    if home == nil then
        home = self:hand()
        home.moved = {0, 0, 0}
        self.home = home
    end
    local dx, dy, dz = x - home.x, y - home.y, z - home.z
    local way = sqrt(dx * dx + dy * dy + dz * dz)
    local share = min(1, speed / 1000 / max(way, 1e-9))
    home.x, home.y, home.z = home.x + share * dx, home.y + share * dy, home.z + share * dz
    local moved = home.moved
    local steps = {}
    for i, whole in ipairs {dx, dy, dz} do
        moved[i] = moved[i] + 1e4 * share * whole
        steps[i] = floor(moved[i] + 0.5)
        if i == 3 then steps[i] = max(-1, min(1, steps[i])) end
        moved[i] = moved[i] - steps[i]
    end
    raw.draw(self.player, steps[1], steps[2])
    raw.move(self.player, 0, -steps[3])
    raw.wait(1)
    raw.move(self.player, 0, 0)
    return way * (1 - share)
end

-- Moves the hand to a place at so many m/s, until it is there, the condition holds or 5 s are over.
function Wizard:hand_to(place, speed, condition)
    for _ = 1, 5000 do
        if self:steer(place, speed) < 1e-6 or condition and condition() then return end
    end
end

-- Holds Stir at the orb and puts on the modes of these keys.
function Wizard:scry(...)
    self.home = nil
    raw.button(self.player, "stir", true)
    raw.wait(50)
    for _, key in ipairs {...} do
        raw.button(self.player, "wand_" .. key, true)
        raw.wait(24)
        raw.button(self.player, "wand_" .. key, false)
        raw.wait(16)
    end
end

function Wizard:scrying() return raw.scrying(self.player) end

function Wizard:core() return raw.core(self.player) end

function Wizard:curve(key, property) return raw.curve(self.player, key, property) end

-- Fetches what is found at a niche, and drops it into the brew from a place at the rim; Stir stays held.
function Wizard:drop_in(niche, at)
    raw.place(self.player, niche)
    raw.wait(100)
    raw.place(self.player, at)
    raw.button(self.player, "stir", true)
    raw.wait(200)
    self:press("fire")
    raw.wait(100)
end

local function place_of(target)
    local kind = getmetatable(target)
    if kind == Wizard then return target:centre() end
    if kind == Thing then return target:position() end
    coordinates(target)
    return target
end

function Wizard:aim(target)
    for _ = 1, 3000 do
        local right, up = raw.counts_to(self.player, place_of(target))
        raw.look(self.player, right, up)
        if right == 0 and up == 0 then return end
        raw.wait(1)
    end
    fail("cannot aim at it within 3 s")
end

-- Walks straight to a place on the ground.
function Wizard:walk_to(x, z)
    local function left()
        local at = self:position()
        return length {at.x - x, 0, at.z - z}, at
    end
    raw.move(self.player, 0, 1)
    for _ = 1, 600 do
        self:aim {x, self:eye().y, z}
        raw.wait(20)
        if left() < 0.5 then break end
    end
    raw.move(self.player, 0, 0)
    local missed, at = left()
    expect(missed < 1, string.format("the way to %g, %g leads to %.1f, %.1f", x, z, at.x, at.z))
end

-- The arm in the hand: it goes there at so many m/s, or is there at once.
function Wizard:reach(place, speed) raw.reach(self.player, place, speed) end

function Wizard:told() return raw.told(self.player) end

function stall(seconds) raw.stall(ticks_of(seconds)) end

function Wizard:place(feet) raw.place(self.player, feet) end

function Wizard:face(yaw, pitch) raw.face(self.player, yaw, pitch or 0) end

function pause(n) wizard(n):press("pause") end

-- searching the orb --------------------------------------------------------------------------------------------------

-- A wizard who searches the orb for its core with the mode of one key, by what the hand feels alone.
local Seeker = {}
Seeker.__index = Seeker

function seeker(n, key)
    local me = wizard(n)
    me:place {-16.5, 0, 0}
    me:face(90, 0)
    wait(0.3)
    me:scry(key)
    return setmetatable({wizard = me}, Seeker)
end

function Seeker:told() return self.wizard:health() > 100 end

-- Goes to a place, until the orb has told.
function Seeker:go(place) self.wizard:hand_to(place, 0.1, function() return self:told() end) end

-- Holds the hand at a place for 1.6 s, or until the orb has told.
function Seeker:wait_at(place)
    self:go(place)
    for _ = 1, 1600 do
        if self:told() then return end
        self.wizard:steer(place, 0.1)
    end
end

function Seeker:beyond(place) return length(place) > 0.058 or abs(place.z) > 0.033 end

-- The mean force while the hand moves about a place, so many metres away from it.
function Seeker:feel(at, away)
    local sum = {0, 0, 0}
    for i = 1, 240 do
        local a, b = pi * i / 60, pi * i / 40
        self.wizard:steer(plus(at, {away * cos(a), away * sin(a), away * sin(b)}), 0.5)
        if i > 40 then sum = plus(sum, self.wizard:force()) end
    end
    return plus({0, 0, 0}, sum, 1 / 200)
end

-- Lets the flow lead the hand from a place for one round: step(way, home) gives the next way and the next place of the hand.
-- Returns the middle of the round, or nil if it leads out of the reach of the hand.
function Seeker:round(from, step)
    self:go(from)
    local way, home, turned, sum, count = {x = 0.6, y = 0.64, z = 0.48}, self.wizard:hand(), 0, {0, 0, 0}, 0
    for i = 1, 3000 do
        local new
        new, home = step(way, home)
        if i > 250 then
            turned = turned + math.acos(max(-1, min(1, dot(way, new))))
            sum, count = plus(sum, self.wizard:hand()), count + 1
        end
        way = new
        if self:beyond(home) or self:told() then return nil end
        self.wizard:steer(home, 0.3)
        if turned > 2 * pi then return plus({0, 0, 0}, sum, 1 / count) end
    end
end

-- Searches by rounds: the middle of a round beside the last middle is nearer to the core.
function Seeker:by_rounds(from, step)
    local middle = self:round(from, step)
    for _ = 1, 3 do
        local better = middle and self:round(plus(middle, {0.006, 0.006, 0.003}), step)
        if not better or self:told() then break end
        local moved = distance(better, middle)
        middle = better
        if moved < 0.004 then break end
    end
    if middle then self:wait_at(middle) end
end

-- Searches on both sides of a ring round the core: until_it_turns(from, sign, most) goes with the force (sign 1) or against
-- it (-1) for at most so many steps, and gives the place at which the force turns round and the way there, or nil.
function Seeker:behind_ring(from, until_it_turns, most_out, most_back)
    local ring, way = until_it_turns(from, 1, most_out)
    for side = 1, ring and -1 or 2, -2 do
        local middle = not self:told() and until_it_turns(plus(ring, way, side * 0.006), -1, most_back)
        if middle then self:wait_at(middle) end
    end
end

-- Calls search(from) for places all over the orb until the orb has told.
function Seeker:from_everywhere(search)
    local far = 0.022
    for _, from in ipairs {
        {0, 0, 0}, {far, 0, 0}, {-far, 0, 0}, {0, far, 0}, {0, -far, 0}, {0, 0, far}, {0, 0, -far},
        {0.015, 0.015, 0.015}, {-0.015, 0.015, 0.015}, {0.015, -0.015, 0.015}, {0.015, 0.015, -0.015},
    } do
        if not self:told() then search(from) end
    end
end

function Seeker:expect_found(message)
    expect(self:told(), message)
    expect_event {kind = "scried", subject = self.wizard.player}
    expect_event {kind = "recipe_told", subject = self.wizard.player}
end

-- things -------------------------------------------------------------------------------------------------------------

function spawn(wish) return setmetatable({number = raw.spawn(wish)}, Thing) end

function Thing:there() return raw.thing_there(self.number) end

function Thing:position() return raw.thing_position(self.number) end

function Thing:velocity() return raw.thing_velocity(self.number) end

function Thing:place(at, velocity) raw.thing_place(self.number, at, velocity) end

function Thing:push(impulse) raw.thing_push(self.number, impulse) end

-- pictures -----------------------------------------------------------------------------------------------------------

local Picture = {}
Picture.__index = Picture

function picture(wish)
    local number, width, height = raw.picture(wish)
    return setmetatable({number = number, width = width, height = height}, Picture)
end

function Picture:mean(x0, y0, x1, y1) return raw.picture_mean(self.number, x0, y0, x1, y1) end

function Picture:colour(x, y) return raw.picture_mean(self.number, x, y, x, y) end

function Picture:colours(x0, y0, x1, y1) return raw.picture_colours(self.number, x0, y0, x1, y1) end
)lua";

}  // namespace thaum::game::inline scenario
