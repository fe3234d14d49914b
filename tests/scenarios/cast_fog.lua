-- An S casts a cloud ahead of its wizard, and nobody sees through it: a shooting bot stops, and shoots again when the
-- cloud has gone. A fast S is harsh: the cloud covers more ground and stays longer.
match {players = {"script", "bot 1"}, set = {"wizard.health.start=1000", "wizard.health.cap=1000", "bolt.energy.regain_per_s=20"}}
clear_props()
local me, foe = wizard(1), wizard(2)
local function face_each_other()
    me:place {0, 0, 19}
    me:face(90, 0)
    foe:place {-9, 0, 19}
    foe:face(-90, 0)
end
local function shots_within(seconds)
    local before, stop = foe:shots(), now() + 1000 * seconds
    while now() < stop do
        face_each_other()
        tick(8)
    end
    return foe:shots() - before
end
expect(shots_within(3) > 3, "the bot sees and shoots")
expect(#fogs() == 0, "there is no cloud yet")
face_each_other()
me:cast("s", {seconds = 1.2})
expect_event {kind = "cast", by = 1, within = 0.1}
local cloud = fogs()[1]
expect_near(cloud.radius, 4, 1e-9, "a gentle cloud")
expect_near(cloud.left, 6, 0.05, "its time")
expect(distance(cloud.place, me:centre()) < cloud.radius, "its wizard is within")
expect(cloud.place.x < me:centre().x - 2, "it is ahead")
expect_near(me:focus(), 80, 1, "its focus")
shots_within(0.8)  -- the bot reacts, and ends what it has begun
expect(shots_within(4) <= 1, "the bot shoots at nothing that it does not see")
wait(1.5)
expect(#fogs() == 0, "the cloud has gone")
expect(shots_within(3) > 3, "the bot sees again")
face_each_other()
me:cast("s", {seconds = 0.3})
expect_near(fogs()[1].radius * fogs()[1].radius, 16 * 1.4, 1e-9, "a harsh cloud covers more")
expect_near(fogs()[1].left, 8.4, 0.05, "it stays longer")
