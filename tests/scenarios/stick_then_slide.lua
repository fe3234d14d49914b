-- A held thing is pressed onto the floor and pulled sideways by the hand. It sticks while the pull is less
-- than friction times pressure, and slides beyond that. The hand feels both.
match {players = {"script", "script"}, forces = {100, 100},
       set = {"lift.energy.per_s=0", "lift.energy.per_n_s=0", "lift.hold.drag_ratio=0.1"}}
clear_props()
local me = wizard(1)
wizard(2):place {-15, 0, -15}
me:place {14, 0, 16}
me:face(-90, 0)
local thing = spawn {kind = "box", size = {1, 0.4, 1}, mass = 20, at = {17, 0.2, 16}, friction = 0.8}
trace("slide", {"1.force_x", "1.force_y", "1.force_z", "1.hand_x", "t1.x", "t1.z"})
wait(0.3)
me:press("wand_4")
me:aim(thing)
wait(0.1)
me:hold("fire")
wait(0.3)
me:look(0, -2.5)  -- into the floor
wait(1)
expect(length(me:force()) > 0.3, "the floor is felt")

-- Pressure and pull along the floor, as forces on the hand (N). Taken out: the 0.2 N by which the thing's
-- weight is felt, since the spring does not cause them.
local function parts()
    local f, p = me:force(), me:pitch()
    local y, z = f.y + 0.2, f.z
    local normal = y * math.cos(p) - z * math.sin(p)
    local along = y * math.sin(p) + z * math.cos(p)
    return normal, length {x = f.x, y = 0, z = along}
end
local from = thing:position()
local stuck, sum, count = 0, 0, 0
me:hold("clutch")
for i = 1, 150 do  -- 0.1 mm of the hand to the right every 20 ms
    me:look(0.05, 0)
    wait(0.02)
    local normal, pull = parts()
    if distance(thing:position(), from) < 0.002 then
        stuck = math.max(stuck, pull / normal)
    elseif distance(thing:position(), from) > 0.03 then
        sum, count = sum + pull / normal, count + 1
    end
end
me:release("clutch")
log("pull over pressure: sticking up to", stuck, "sliding at", sum / count)
expect(stuck > 0.3, "the tip sticks while the pull grows")
expect(count > 20, "the tip slides afterwards")
expect_near(sum / count, 0.8 * 0.8, 0.1, "friction force while sliding")
