-- The surface holds the ladle up to its pop-through force. Inside the brew the ladle no longer feels the
-- surface. When drawn out it clings to the surface.
match {players = {"script", "script"}, set = {"haptics.share=1"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
me:place {-2.2, 0, 0}
me:hold("stir")
trace("surface", {"1.hand_y", "1.force_y"})
wait(0.1)
me:move(0, 1)  -- up and out
wait_until(function() return me:ladle().y > brew().middle.y + 0.1 end, 3)
me:stop()
wait(1.2)
expect_near(me:force().y, 0, 0.02, "no force above the surface")
me:move(0, -0.35)
local most, rest = 0, brew().middle.y
local dent = 0
wait_until(function()
    most = math.max(most, me:force().y)
    dent = math.min(dent, surface(me:ladle()) - rest)
    return me:ladle().y < rest - 0.14
end, 6)
me:stop()
expect(most > 0.8 and most < 1.3, "largest force at the surface: " .. most .. " N; 160 N in the world")
expect(dent < -0.02, "the surface gives way")
wait(1)
expect(math.abs(me:force().y) < 0.3 * most, "the surface is not felt inside the brew")
expect(me:created() <= 0.02, "the surface creates no energy")
