-- The wand's tip feels the bowl's rim below it, and a crate that flies against it. A wizard who turns or
-- walks into a wall with the wand gets no force from that.
match {players = {"script", "script"}}
clear_props()
local me = wizard(1)

-- The tip hangs over the rim, which is 1.1 m high and 1.35 to 1.5 m from the middle. The tip is 0.22 m right
-- of the eye, 0.2 m below its 1.65 m, and 0.75 m ahead.
me:place {-0.22, 0, 2.18}
me:face(0)
wait(0.5)
trace("rim", {"1.hand_y", "1.force_y"})
expect_near(length(me:force()), 0, 0, "no force without contact")

-- The hand goes down by 38 mm, and a tenth of the 0.35 m to the rim is 35 mm. The hand's spring of 400 N/m
-- and the rim's of 250 N/m meet in between, up to the dry friction of 0.26 N.
me:hold("clutch")
me:look(0, -19)
me:release("clutch")
wait(0.5)
expect_near(me:hand().y, -(400 * 0.038 + 250 * 0.035) / 650, 0.0005, "position of the hand on the rim")
expect_near(me:force().y, 250 * (-0.035 - me:hand().y), 0.02, "force of the rim")
expect_near(me:force().z, 0, 0.02)

local function strongest(seconds)
    local last, most = time() + seconds, 0
    while time() < last do
        tick()
        most = math.max(most, length(me:force()))
    end
    return most
end

-- Turning moves the tip along the rim and off it without a kick.
local pressed = length(me:force())
me:look(60, 0)
expect(strongest(0.5) < pressed + 0.1, "no kick while the view turns")
expect_near(length(me:force()), 0, 0, "no force off the rim")

-- The wizard walks into a wall with the wand ahead.
me:hold("clutch")
me:look(0, 19)
me:release("clutch")
me:place {17, 0, 1}
me:face(-90)
wait(0.5)
me:move(0, 1)
expect(strongest(1.5) < 0.05, "no force while the wizard walks into the wall")
me:stop()
expect(me:position().x > 19.5, "the wizard has reached the wall")
expect(strongest(1) < 0.05, "no force while the wizard stands at the wall")

-- A thing that flies against the tip is felt and pushes the hand aside.
me:place {-10, 0, 0}
me:face(0)
wait(0.5)
local hand = me:hand().x
local crate = spawn {kind = "box", size = {0.6, 0.6, 0.6}, mass = 5, at = {-8.8, 1.6, -0.75}, velocity = {-4, 1, 0}}
local left = 0
for _ = 1, 400 do
    tick()
    left = math.max(left, -me:force().x)
end
expect(left > 0.3, "a crate against the wand: " .. left .. " N")
