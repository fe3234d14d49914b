-- A star calls back the thing that its wizard took up last. With the Lift wand in hand it is caught and can be thrown
-- again; with another wand it lands before the wizard. A fast star is harsh: the thing is faster, and shoves what it
-- meets. Without such a thing there is nothing to recall, and that costs nothing.
match {players = {"script", "script"}}
clear_props()
local me, foe = wizard(1), wizard(2)
foe:place {15, 0, -15}
me:place {0, 0, 19}
me:face(90, 0)
me:cast("star", {seconds = 1.5, size = 0.08})
expect_event {kind = "fizzled", by = 1, within = 0.1}
expect_near(me:focus(), 100, 0, "a recall of nothing costs nothing")

local ball = spawn {kind = "sphere", radius = 0.25, mass = 12, at = {-3, 0.25, 19}}
wait(0.3)
me:press("wand_4")
me:aim(ball)
me:hold("fire")
wait(0.5)
expect(ball:position().y > 0.27 or length(ball:velocity()) > 0, "the ball is taken up")
me:release("fire")
wait(0.5)
ball:place {-14, 0.25, 14}
me:face(90, 0)
wait(0.5)

-- The thing is caught by the wand, held without fire, and thrown again.
me:cast("star", {seconds = 1.5, size = 0.08})
expect_event {kind = "cast", by = 1, within = 0.1}
local top = 0
wait_until(function()
    top = math.max(top, length(ball:velocity()))
    return distance(ball:position(), me:eye()) < 2
end, 3)
expect(top > 10 and top < 14.5, "the speed of a gentle recall, not " .. top)
wait(1)
expect(distance(ball:position(), me:eye()) < 2.2, "the wand holds it")
expect(ball:position().y > 0.8, "in the air")
me:press("throw", 0.05)
wait(0.2)
expect(length(ball:velocity()) > 8, "it is thrown again")

-- With another wand in hand the thing lands before the wizard.
wait(2)
me:press("wand_1")
wait(0.1)
me:face(90, 0)
ball:place {-14, 0.25, 14}
me:cast("star", {seconds = 1.5, size = 0.08})
expect_event {kind = "cast", by = 1, within = 0.1}
wait(3)
expect(distance(ball:position(), me:position()) < 3.5, "it lies at the feet")
expect(ball:position().y < 0.3, "on the ground")

-- A harsh star brings the thing through the foe, and a gentle one brings it out of the pit.
wait(8)
ball:place {-6, -4.7, 9}
foe:place {-4, 0, 19}
foe:face(0, 0)
wait(0.3)
ball:place {-12, 0.8, 19}
local from = foe:position()
me:cast("star", {seconds = 0.5, size = 0.08})
expect_event {kind = "cast", by = 1, within = 0.1}
expect_event {kind = "pushed", subject = 2, by = 1, within = 2}
wait(1)
expect(foe:position().x > from.x + 0.5, "the foe is shoved towards the caster")
wait(3)
ball:place {-6, -4.7, 9}
me:place {-6, 0, 3}
me:face(180, 0)
wait(5)
me:cast("star", {seconds = 1.5, size = 0.08})
expect_event {kind = "cast", by = 1, within = 0.1}
wait(3)
expect(ball:position().y > -0.1, "it comes out of the pit")
