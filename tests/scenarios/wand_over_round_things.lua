-- The wand's tip is pressed onto a ball and drawn over it. For any friction the force follows the curve and
-- never drops.
match {players = {"script", "script"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
me:place {-10, 0, 0}
me:face(0)
wait(0.5)

-- A resting hand holds the tip 0.22 m right of the eye, 0.2 m below its 1.65 m, and 0.75 m ahead. A
-- millimetre of the hand is a centimetre of the tip. A degree of the mouse is two millimetres of the hand.
local tip = {x = -9.78, y = 1.45, z = -0.75}

local function draw_over(friction, place)
    local stand = spawn {kind = "box", size = {0.12, 1, 0.12}, mass = 10000, at = {tip.x, 0.5, tip.z}}
    local ball = spawn {kind = "sphere", radius = 0.15, mass = 10000, at = {tip.x, 1.16, tip.z}, friction = friction}
    wait(1)
    me:hold("clutch")
    me:look(-3, 0)
    me:look(0, -11)
    wait(0.5)
    local weakest, jump, before = 1e9, 0, me:force()
    local from = me:hand().x
    for i = 1, 600 do  -- 120 counts: 12 mm of the hand
        me:stroke(i % 5 == 0 and 1 or 0, 0)
        tick()
        local f = me:force()
        weakest = math.min(weakest, length(f))
        jump = math.max(jump, length {f.x - before.x, f.y - before.y, f.z - before.z})
        before = f
    end
    local way = me:hand().x - from
    me:look(0, 11)
    me:draw(-1, 0, 0.12)
    me:look(3, 0)
    me:release("clutch")
    wait(0.5)
    ball:place {place, 3, 12}
    stand:place {place, 3, 8}
    wait(0.5)
    return weakest, jump, way
end

for i, friction in ipairs {0.2, 0.5, 0.8} do
    local weakest, jump, way = draw_over(friction, 10 + 2 * i)
    log("friction", friction, "weakest", weakest, "N, largest change in a tick", jump, "N over", way, "m")
    expect(way > 0.008, "the hand went over it: " .. way .. " m")
    expect(weakest > 0.5, "friction " .. friction .. ": the ball is felt all the way: " .. weakest .. " N")
    -- Where the tip slips, static friction changes to dynamic friction. A complete drop of the force would be
    -- more than twice that.
    expect(jump < 0.5, "friction " .. friction .. ": no drop: " .. jump .. " N")
end
