-- A thing that falls into the brew moves the brew, and the brew slows the thing.
match {players = {"script", "script"}}
clear_props()
wizard(1):place {15, 0, 15}
wizard(2):place {-15, 0, -15}
wait(0.1)
expect(brew().asleep, "an untouched brew is asleep")
local ball = spawn {kind = "sphere", radius = 0.25, mass = 30, at = {0.2, 3, 0}}
wait(0.6)
local fast = ball:velocity().y
expect(fast < -5)
wait(0.25)
expect(ball:velocity().y > 0.5 * fast, "the brew slows the ball")
wait(0.3)
expect(brew().speed > 0.02, "the ball moves the brew")
expect(not brew().asleep)
