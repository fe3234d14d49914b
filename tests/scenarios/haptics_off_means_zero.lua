-- A player with forces switched off feels none, whatever happens, and plays the same match.
match {players = {"script", "script"}, forces = {0, 100}}
clear_props()
local me, foe = wizard(1), wizard(2)
me:place {8, 0, 16}
me:face(-90, 0)
foe:place {14, 0, 14}
foe:face(90, 0)
local thing = spawn {kind = "box", size = {0.6, 0.6, 0.6}, mass = 60, at = {11, 0.3, 16}}
trace("off", {"1.force_x", "1.force_y", "1.force_z", "1.hand_x", "2.force_z"})
local all = 0
local function go(seconds)
    local last = time() + seconds
    while time() < last do
        tick()
        all = all + length(me:force())
    end
end
me:hold("fire") foe:hold("fire")
go(1)
expect(me:shots() >= 8, "bolts fly")
me:release("fire") foe:release("fire")
me:press("wand_4")
me:aim(thing)
go(0.2)
me:hold("fire")
go(0.2)
me:look(0, 12)
go(1)
expect(thing:position().y > 0.6, "the thing is lifted")
me:hold("clutch")
me:look(10, 0)
go(1)
expect(me:hand().x > 0.015, "the hand moves")
me:release("clutch")
me:press("throw")
go(0.5)
expect_near(all, 0, 0, "sum of the forces")
expect(me:force_cause() == "off")
