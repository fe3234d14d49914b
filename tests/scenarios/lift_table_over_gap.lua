-- The table (7 m, 40 kg) is lifted by its near end, turned with the wizard, laid across the pit (6 m) and
-- walked over.
match {players = {"script", "script"}}
clear_props()
local me = wizard(1)
wizard(2):place {-15, 0, -15}
local table_ = spawn {kind = "box", size = {7, 0.1, 1.2}, mass = 40, at = {-8.8, 0.05, 5}, surface = "table"}
me:place {-4, 0, 5}
me:face(90, 0)  -- towards -x, along the table
trace("table", {"1.x", "1.y", "1.z", "1.force_x", "1.force_y", "1.force_z", "1.energy", "t1.x", "t1.y", "t1.z"})
wait(0.3)
me:press("wand_4")
me:aim {-5.6, 0.1, 5}
wait(0.1)
me:hold("fire")
wait(0.2)
me:look(0, 8)
wait(1)
expect(table_:position().y > 0.4, "the table is lifted")
expect_near(me:force().y, -0.01 * 40 * 0.45, 0.03, "weight felt through the fader and the player's 45 %")

-- Turns to the pit. The far end of the table turns with the wizard.
me:look(-90, 0)  -- to the left: from -x to +z
wait(1.5)
local reach = table_:position().z - me:position().z
expect(reach > 4 and reach < 6, "the table points across the pit")
expect_near(table_:position().x, me:position().x, 0.5)
picture {name = "carried"}

-- Walks backward until the table's middle is over the pit's middle, z = 9.
me:move(0, -1)
wait_until(function() return table_:position().z < 9.2 end, 3)
me:stop()
wait(0.5)
me:look(0, -8)
wait(1.5)
me:release("fire")
wait(0.1)
local energy = me:energy()
wait(1)
expect_near(table_:position().y, 0.05, 0.02, "the table lies on both edges")
expect(me:energy() >= energy, "a table that was let go costs no energy")
expect_near(length(me:force()), 0, 1e-9, "a table that was let go is not felt")

-- Walks over the table.
me:move(0, 1)
wait_until(function() return me:position().z > 12.6 end, 6)
me:stop()
expect(me:position().y > -0.05, "the wizard walks over the pit")
expect(me:health() == 100)
expect(me:created() <= 0.02, "the spring creates no energy")
