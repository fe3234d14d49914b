-- A bolt that hits a crystal melts a ball of two voxels where it strikes the surface. One that flies past it, and one that
-- hits the wall, melt nothing.
match {players = {"script", "script"}, seed = 2}
clear_props()
local me = wizard(1)
local c = crystal(1)
expect(not c.touched and c.overlap > 0.4 and c.overlap < 0.65, "the overlap of an untouched crystal: " .. c.overlap)
me:place {c.middle.x, 0, c.middle.z - 1.5}
me:hold("stir")
wait(0.1)
me:release("stir")
local before = crystal(1)
expect(before.touched and before.hash, "a hand has touched the crystal")
expect(before.overlap == c.overlap, "a touch alone changes no overlap")

local function shoot_at(place)
    me:aim(place)
    me:hold("fire")
    wait(0.02)
    me:release("fire")
    wait(0.5)
end

me:place {c.middle.x, 0, c.middle.z - 3}
wait(0.3)
shoot_at {c.middle.x + 3, c.middle.y, c.middle.z}
shoot_at {c.middle.x, c.middle.y + 1.2, c.middle.z}
expect(me:shots() >= 2, "shots were fired")
expect(#events {kind = "chipped"} == 0, "a far bolt chips nothing")
expect(crystal(1).hash == before.hash, "and changes no voxel")

-- Whatever the key in the crystal, its shaft lies in the middle, so a shot there strikes solid matter.
local eye = me:eye()
local seen = crystal_ray(1, eye, {c.middle.x - eye.x, c.middle.y - eye.y, c.middle.z - eye.z})
expect(seen, "the crystal is in the crosshair")
shoot_at(c.middle)
local hit = expect_event {kind = "chipped", by = 1, within = 1}
expect(crystal(1).hash ~= before.hash, "the crystal is chipped")
-- A ball of radius 2 has 33 voxels. About half of it lies in the solid.
expect(hit.amount > 4 and hit.amount < 40, "voxels: " .. hit.amount)
expect(distance(hit.place, seen) < 0.15, "where the bolt struck")
expect(crystal_density(1, hit.place) < 0.1, "nothing is left there")
expect(not crystal(2).touched, "the other crystal is untouched")
