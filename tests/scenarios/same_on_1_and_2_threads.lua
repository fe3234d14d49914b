-- A brew stirred by two players is the same to the bit, whether its steps run on the match's own thread or on
-- one or two others.
match {seed = 3, players = {"script", "script"}}
local sides = {-1, 1}
for player = 1, 2 do wizard(player):move(sides[player], 0) end
wait(0.8)
for player = 1, 2 do
    wizard(player):stop()
    wizard(player):aim {0, 1, 0}
    wizard(player):move(0, 1)
end
wait_until(function() return distance(wizard(1):position(), {0, 1, 0}) < 2.6 and distance(wizard(2):position(), {0, 1, 0}) < 2.6 end, 8)
for player = 1, 2 do
    wizard(player):stop()
    wizard(player):hold("stir")
end
wait(0.3)
for player = 1, 2 do
    wizard(player):draw(0, -2, 0.16)
    wizard(player):circles(1, 0.8, 4)
end
expect(brew().speed > 0.3, "speed of the stirred brew: " .. brew().speed)
for count = 1, 2 do check_threads(count) end
