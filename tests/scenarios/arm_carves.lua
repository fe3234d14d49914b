-- A player with a real arm carves: the arm presses into a crystal, feels its surface push back, within half a voxel of
-- where the picture shows it, and melts a way in. The forces stay within the cap and give the arm no energy.
match {players = {"script", "script"}, arms = {true, false}, seed = 6}
local me = wizard(1)
local middle, voxel = crystal(1).middle, crystal(1).voxel
me:place {middle.x, 0, middle.z - 1.5}
me:reach({0, 0, 0.03}, 0.2)
wait(2)
me:hold("stir")
wait(0.5)
expect(carver(1).place, "the wizard works at the crystal")
local before = crystal(1)
-- A place across the view where the surface lies well within reach.
local x
for i = -12, 12 do
    local met = crystal_ray(1, {middle.x + 0.01 * i, middle.y, middle.z - 0.6}, {0, 0, 1})
    if met and met.z < middle.z - 2 * voxel and not x then x = -0.01 * i / 5.5 end
end
expect(x, "the crystal is in front")
me:reach({x, 0, 0.03}, 0.2)
wait(0.5)
me:reach({x, 0, -0.02}, 0.05)
local stopped, strongest
for _ = 1, 1500 do
    wait(0.001)
    local force = length(me:force())
    strongest = math.max(strongest or 0, force)
    if not stopped and force > 0.6 then stopped = carver(1).place end
end
expect(stopped, "the surface stops the arm")
local seen = crystal_ray(1, {stopped.x, stopped.y, middle.z - 0.6}, {0, 0, 1})
expect(seen and distance(seen, stopped) <= 0.5 * voxel, "where the picture shows it: " .. distance(seen or middle, stopped) / voxel)
expect(strongest < 1.6, "within the cap: " .. strongest)
expect(carver(1).force.z < -0.3, "it pushes the arm back")
local outside = carver(1).place
expect(crystal(1).hash == before.hash, "a hand alone changes nothing")
me:hold("fire")
wait(1)
me:release("fire")
expect(crystal(1).hash ~= before.hash and crystal(1).carver == 1, "fire carves")
expect(carver(1).place.z > outside.z + voxel, "the tool has come in")
me:reach({0, 0, 0.03}, 0.2)
wait(1)
expect(length(me:force()) < 0.1, "nothing holds a hand that is out")
expect(me:created() < 0.02, "energy given to the arm: " .. me:created() .. " J")
