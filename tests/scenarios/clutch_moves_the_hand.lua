-- While the clutch is held, the mouse moves the hand by 0.1 mm per count, and the view stays still. The hand
-- stays in the device's workspace, and the wand's tip moves ten times as far.
match {players = {"script", "script"}}
trace("hand", {"1.hand_x", "1.hand_y", "1.yaw"})
local me = wizard(1)
local yaw, pitch = me:yaw(), me:pitch()
me:hold("clutch")
me:look(10, 5)  -- 0.05 degrees per count
wait(0.5)
expect_near(me:yaw(), yaw, 0, "the view stands still while the clutch is held")
expect_near(me:pitch(), pitch, 0)
expect_near(me:hand().x, 0.020, 0.001, "way of the hand for 200 counts to the right, less the effect of dry friction")
expect_near(me:hand().y, 0.010, 0.001, "way of the hand for 100 counts up")
me:release("clutch")
me:look(5, 0)
wait(0.5)
expect(math.abs(me:yaw() - yaw) > 0.05, "without the clutch the mouse turns the view")
expect_near(me:hand().x, 0.020, 0.001, "without the clutch the hand stays")
