-- A V throws back the foe and the loose things ahead, the lighter the faster. What is behind or too far stays. A fast V
-- is harsh. A wizard who falls after a push has been felled by the caster.
match {players = {"script", "script"}}
clear_props()
local me, foe = wizard(1), wizard(2)
local function face_foe(metres)
    me:place {0, 0, 19}
    me:face(90, 0)
    foe:place {-metres, 0, 19}
    foe:face(0, 0)
    wait(0.3)
end
-- Casts a V in so many seconds. Returns how far it pushes the foe along the ground (m).
local function pushed_by(seconds)
    local from = foe:position()
    me:cast("v", {seconds = seconds})
    expect_event {kind = "cast", by = 1, within = 0.1}
    wait(1)
    return from.x - foe:position().x
end
face_foe(3)
local gentle = pushed_by(1)
log("gentle push", gentle)
expect(gentle > 2 and gentle < 3, "a standing wizard goes back by 2 to 3 m, not " .. gentle)
expect_near(expect_event({kind = "pushed", subject = 2, by = 1}).amount, 8, 1e-9, "the speed")
expect_near(me:focus(), 84, 1, "20 of the focus, and 4 a second come back")
expect(foe:health() == 100, "a push alone does not hurt")
face_foe(3)
local harsh = pushed_by(0.3)
log("harsh push", harsh)
expect(harsh > gentle + 1, "a harsh push throws farther")
face_foe(6)
expect_near(pushed_by(1), 0, 0.01, "a foe out of reach stays")
me:face(-90, 0)
foe:place {-3, 0, 19}
expect_near(pushed_by(1), 0, 0.01, "a foe behind stays")

-- Loose things are thrown back the faster, the less mass they have.
wait(10)
foe:place {15, 0, -15}
local function throw_of(mass)
    me:place {0, 0, 19}
    me:face(90, 0)
    local thing = spawn {kind = "box", size = {0.5, 0.5, 0.5}, mass = mass, at = {-3, 0.25, 19}}
    wait(0.3)
    me:cast("v", {seconds = 1})
    wait(0.03)
    local speed = length(thing:velocity())
    wait(2)
    local way = -3 - thing:position().x
    log("thing of", mass, "kg: speed", speed, "way", way)
    thing:place {15, 0.25, 15}
    return speed, way
end
local light, light_way = throw_of(20)
local heavy, heavy_way = throw_of(120)
expect(light > 11 and light < 12.5, "a crate flies")
expect(light_way > 4, "and far")
expect(heavy > 4 and heavy < 5.5, "a heavy one is slower")
expect(heavy_way > 0.3 and heavy_way < light_way, "and goes less far")

-- Over the edge of the pit: the foe is hurt by the fall, and it counts for the caster.
wait(6)
me:place {-6, 0, 3.5}
me:face(180, 0)
foe:place {-6, 0, 5}
foe:face(0, 0)
wait(0.3)
me:cast("v", {seconds = 1})
local fall = expect_event {kind = "fall", subject = 2, within = 3}
expect(fall.amount > 15, "the fall hurts")
