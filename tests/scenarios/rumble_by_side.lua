-- The pad's motors are the sides of the body: a bolt from the left runs the left one alone, one from the right the right
-- one, one from ahead both alike.
match {players = {"script", "script"}, set = {"bolt.shot.damage=1"}}
clear_props()
senses {layouts = {"pad"}}
local me, foe = wizard(1), wizard(2)

-- Strongest amplitude of each motor while a bolt is felt that comes from dx and dz metres away.
local function struck_from(dx, dz)
    me:place {0, 0, 12}
    me:face(0)
    foe:place {dx, 0, 12 + dz}
    wait(0.3)
    foe:aim(me)
    local before = #events {kind = "bolt_hit", subject = 1}
    foe:press("fire")
    wait_until(function() return #events {kind = "bolt_hit", subject = 1} > before end, 2)
    local left, right = 0, 0
    for _ = 1, 12 do
        tick(8)
        local motors = body(1, "pad")
        left, right = math.max(left, motors[1].felt), math.max(right, motors[2].felt)
    end
    wait(0.3)
    return left, right
end

local left, right = struck_from(-6, 0)
expect(left > 0.2 and right < 0.1 * left, "from the left")
left, right = struck_from(6, 0)
expect(right > 0.2 and left < 0.1 * right, "from the right")
left, right = struck_from(0, -6)
expect(left > 0.1, "from ahead")
expect_near(left, right, 0.35 * left, "from ahead both alike")
for i, motor in ipairs(body(1, "pad")) do expect_near(motor.felt, 0, 0, "motor " .. i .. " at the end") end
