-- A fall soon after the foe's shot is credited to the foe. So is the blow of a thing that the foe has set in
-- motion.
match {set = {"wizard.health.start=3.5", "bolt.shot.damage=1", "bolt.shot.spread_deg=0"}, players = {"script", "script"}}
local me, foe = wizard(1), wizard(2)
local pit = {-5, 1.6, -9}

-- Walks the foe into the pit.
local function fall()
    foe:place {-11, 0, -9}
    foe:face(-90)
    foe:move(0, 1)
    local death = expect_event {kind = "death", subject = 2, within = 5}
    foe:stop()
    return death
end

-- One hit leaves 2.5 HP, and the fall into the pit of 5 m costs 28 HP.
me:aim(foe)
wait(0.5)
me:press("fire")
expect_event {kind = "bolt_hit", subject = 2, by = 1, within = 2}
foe:aim(pit)
wait(0.3)
foe:move(0, 1)
local death = expect_event {kind = "death", subject = 2, within = 5}
foe:stop()
expect_near(death.by or 0, 1, 0, "the shooter gets the kill")
expect_near(me:kills(), 1, 0)
expect_near(foe:kills(), 0, 0)
expect_near(foe:deaths(), 1, 0)
expect_near(deeds(1, "fall").kills, 1, 0)
expect_near(deeds(2, "fall").own_deaths, 0, 0)

-- Without a shot, a fall is credited to no player.
wait(5)
death = fall()
expect(death.by == nil, "no player gets the kill")
expect_near(me:kills(), 1, 0)
expect_near(foe:kills(), -1, 0, "the fall costs one kill")
expect_near(deeds(2, "fall").own_deaths, 1, 0)

-- A shot 5 s ago no longer counts.
wait_until(function() return not foe:dead() and not foe:shielded() end, 6)
foe:place {-15, 0, -15}
me:aim(foe)
wait(0.5)
me:press("fire")
expect_event {kind = "bolt_hit", subject = 2, by = 1, within = 2}
wait(5)
death = fall()
expect(death.by == nil, "a shot 5 s ago gets no kill")
expect_near(foe:kills(), -2, 0)

-- A kill by a thing that player 1 has shot is player 1's. A kill by an untouched thing is credited to no
-- player.
local function throw(shot_first)
    wait_until(function() return not foe:dead() and not foe:shielded() end, 6)
    me:place {-15, 0, 15}
    foe:place {14, 0, 16}
    local ball = spawn {kind = "sphere", radius = 0.25, mass = 20, at = {-15, 0.25, 11}}
    wait(0.3)
    if shot_first then
        me:aim(ball:position())
        wait(0.5)
        me:press("fire")
        wait(0.3)
        expect(length(ball:velocity()) > 0.05, "the bolt moves the ball")
    end
    ball:place({14, 1.1, 13}, {0, 0, 12})
    local dead = expect_event {kind = "death", subject = 2, within = 1}
    ball:place {0, 0.3, 5}
    return dead
end
local kills = me:kills()
death = throw(true)
expect_near(death.by or 0, 1, 0, "the player who shot the ball gets the kill")
expect_near(me:kills(), kills + 1, 0)
expect_near(deeds(1, "blow").kills, 1, 0)
death = throw(false)
expect(death.by == nil, "a kill by an untouched ball is credited to no player")
expect_near(me:kills(), kills + 1, 0)
