-- A bot of level 3 holds a lifted stone between itself and a shooting foe, and few shots reach the bot.
match {
    players = {"bot 3", "script"},
    set = {"bolt.energy.regain_per_s=100", "bolt.shot.spread_deg=0", "bolt.shot.damage=0.01"},
}
clear_props()
local bot, foe = wizard(1), wizard(2)
bot:place {-14, 0, 18}
bot:face(0, 0)
foe:place {-14, 0, 7}
foe:face(180, 0)
local function stand_fire(seconds)
    local before = deeds(2, "bolt")
    local stop = now() + 1000 * seconds
    while now() < stop do  -- aiming at a foe who sidesteps takes time
        foe:aim(bot)
        tick()
    end
    local after = deeds(2, "bolt")
    return (after.hits - before.hits) / (after.shots - before.shots)
end
foe:press("wand_1")
foe:hold("fire")
stand_fire(1.5)
local at = bot:position()
local stone = spawn {kind = "box", size = {1, 1, 1}, mass = 60, at = {at.x, 0.5, at.z - 4}}
trace("block", {"1.x", "1.z", "1.health", "t1.x", "t1.y", "t1.z"})
local function lifted()
    foe:aim(bot)
    return stone:position().y > 0.85
end
wait_until(lifted, 4)
expect(stone:position().y > 0.85, "the bot lifts the stone")
expect(stand_fire(1.5) < 0.25, "the stone blocks most shots")
foe:release("fire")
wait_until(function() return length(stone:velocity()) > 8 end, 4)
expect(length(stone:velocity()) > 8, "the bot throws the stone after the shooting has stopped")
