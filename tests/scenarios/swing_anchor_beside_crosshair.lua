-- An anchor within 4 degrees of the crosshair is chosen if nothing else is in reach there. An anchor farther
-- away is not.
match {players = {"script", "script"}}
local me = wizard(1)
wizard(2):place {-15, 0, -15}
me:press("wand_5")
for _, case in ipairs {{5, true}, {15, false}} do
    me:place {4, 0, 5}
    me:face(180, 0)
    wait(0.3)
    me:aim {4, 7, 9}
    wait(0.1)
    me:look(case[1], 0)
    wait(0.3)
    local before = me:energy()
    me:hold("fire")
    wait(0.5)
    expect((me:energy() < before - 2) == case[2], case[1] .. " degrees of yaw beside it")
    expect((me:position().y > 0.3) == case[2], "the wizard hangs only from an anchor near the crosshair")
    me:release("fire")
    wait(1.5)
end
