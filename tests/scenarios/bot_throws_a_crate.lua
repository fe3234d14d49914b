-- A bot of level 3 lifts the crate beside it and throws it at a foe who stands still.
match {players = {"bot 3", "script"}}
clear_props()
wizard(1):place {-14, 0, 18}
wizard(1):face(0, 0)
wizard(2):place {-14, 0, 9}
wizard(2):face(180, 0)
local crate = spawn {kind = "box", size = {0.8, 0.8, 0.8}, mass = 25, at = {-12, 0.4, 14}}
trace("throw", {"1.energy", "2.health", "t1.x", "t1.y", "t1.z", "t1.speed"})
wait_until(function() return crate:position().y > 0.8 end, 12)
expect(crate:position().y > 0.8, "the bot lifts the crate")
wait_until(function() return length(crate:velocity()) > 10 end, 6)
expect(length(crate:velocity()) > 10, "the bot throws the crate")
expect_event {kind = "object_hit", subject = 2, by = 1, within = 3}
