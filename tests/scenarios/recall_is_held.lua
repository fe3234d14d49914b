-- A recall that can bring nothing costs nothing. A caught thing is held without fire for some seconds; a press of fire, a
-- throw or the end of that time lets it go, and it is told how.
match {players = {"script", "script"}, set = {"lift.energy.cap=1000"}}
clear_props()
local me, foe = wizard(1), wizard(2)
foe:place {15, 0, -15}
me:place {0, 0, 19}
me:face(90, 0)
local ball = spawn {kind = "sphere", radius = 0.25, mass = 12, at = {-3, 0.25, 19}}
local function star() me:cast("star", {seconds = 1.5, size = 0.08}) end
local function fizzles(why)
    star()
    expect_event {kind = "fizzled", by = 1, within = 0.1}
    expect(#events {kind = "fizzled", by = 1} > 0, why)
end
fizzles("nothing was lifted yet")
wait(0.3)
me:press("wand_4")
me:aim(ball)
me:hold("fire")
wait(0.3)
fizzles("the thing is in the hand")
me:release("fire")
wait(0.5)

-- Recalls the ball into the hand.
local function catch()
    ball:place {-12, 0.25, 19}
    me:face(90, 0)
    wait(0.3)
    star()
    local caught = expect_event {kind = "caught", subject = 1, within = 3}
    expect_near(caught.amount, 12, 1e-9, "the mass of the ball (kg)")
    wait(0.5)
    expect(ball:position().y > 0.8, "held in the air")
end
catch()
local energy = me:energy()
wait(4)
expect(ball:position().y > 0.8, "still held")
expect(me:energy() < energy - 8, "holding costs energy")
wait(1.5)
expect(ball:position().y < 0.4, "let go after five seconds")
energy = me:energy()
wait(1)
expect(me:energy() > energy, "and costs no more energy")

-- A press of fire takes over: the ball is held as long as fire is pressed, and let go with it.
catch()
me:press("fire", 0.1)
wait(1)
expect(ball:position().y < 0.4, "let go by a press of fire")
catch()
me:hold("fire")
wait(6)
expect(ball:position().y > 0.8, "held by fire for longer than five seconds")
me:release("fire")
wait(1)
expect(ball:position().y < 0.4, "let go with fire")
