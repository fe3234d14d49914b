-- Two ladles in one brew: each player feels the other's stirring.
match {players = {"script", "script"}, set = {"haptics.share=1"}}
clear_props()
local one, two = wizard(1), wizard(2)
one:place {-2.2, 0, 0}
two:place {2.2, 0, 0}
one:hold("stir") two:hold("stir")
wait(0.4)
expect(one:stirs() and two:stirs())
expect_near(length(two:force()), 0, 0.01, "no force at rest")
trace("two", {"1.force_x", "1.force_z", "2.force_x", "2.force_z"})
local felt = 0
one:circles(2.5, 1, 3, 1, function() felt = math.max(felt, length(two:force())) end)
expect(felt > 0.05, "force on the other hand: " .. felt)
