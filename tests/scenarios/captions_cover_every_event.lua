-- Everything that is heard or felt has words: each kind of event with a sound or an effect, when it happens; and in play
-- the shot and its kick, steps, a jump, the charge of a blast with its force on the hand, and the side of a hit.
match {players = {"script", "script"}, set = {"bolt.shot.damage=1"}}
senses {}
local me, foe = wizard(1), wizard(2)

local told = {}
local function listen(seconds)
    for _ = 1, math.floor(seconds * 125) do
        tick(8)
        for _, line in ipairs(heard(1)) do
            expect(#line.line > 0, "a line has words")
            told[line.line] = true
        end
    end
end
local function expect_told(line) expect(told[line], "'" .. line .. "' is told") end

-- Captions of what a player does and feels in play.
me:move(0, 1)
listen(1.5)
me:press("jump")
listen(1)
me:stop()
expect_told("step")
expect_told("jump")
me:press("fire")
listen(0.2)
expect_told("bolt")
expect_told("wand kicks")
me:press("next_wand")
me:hold("fire")
listen(1)
expect_told("wand change")
expect_told("blast charging")
expect_told("charge pulls towards you")
me:release("fire")
listen(0.5)
expect_told("blast flies")

-- Each kind of event, long enough apart that no line of the one before is left.
local count = 0
for _, row in ipairs(event_rows()) do
    listen(1.7)
    local before = {}
    for _, line in ipairs(heard(1)) do before[line.line] = true end
    local at = me:centre()
    local back = {at.x + 3 * math.sin(me:yaw()), at.y, at.z + 3 * math.cos(me:yaw())}
    happen {kind = row.kind, subject = 1, by = 2, amount = 20, at = back}
    told = {}
    tick(16)
    local new
    for _, line in ipairs(heard(1)) do
        if not before[line.line] then new = line end
    end
    expect(new, "the event '" .. row.kind .. "' is told")
    count = count + 1
    if row.kind == "bolt_hit" or row.kind == "blast_hit" or row.kind == "lob_hit" then
        expect(new.side == "behind", row.kind .. " is told with its side, not '" .. new.side .. "'")
        expect(new.important, row.kind .. " is important")
    end
end
expect(count >= 15, "kinds of event: " .. count)
