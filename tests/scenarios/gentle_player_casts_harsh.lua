-- The force of a stroke is read before cap and faders: a player without forces, or with a tenth of them, casts harshly
-- and gently with the same strokes as a player with all.
match {players = {"script", "script"}, forces = {100, 0}, set = {"casting.focus.regain_per_s=100"}}
local strong, none = wizard(1), wizard(2)
local function cast_of(who, seconds)
    who:cast("circle", {seconds = seconds})
    local cast = expect_event {kind = "cast", by = who.player, within = 0.1}
    wait(1)
    return cast.amount, who:reading().force
end
for _, seconds in ipairs {1.2, 0.35} do
    local strength, force = cast_of(strong, seconds)
    expect_near(strength, seconds < 1 and 1.4 or 1, 1e-9, "full forces")
    local other, felt = cast_of(none, seconds)
    expect_near(other, strength, 0, "no forces")
    expect_near(felt, force, 0.12 * force, "nearly the same force: only the hand is a little faster")
end
strong:fader("force", 10)
tick()
for _, seconds in ipairs {1.2, 0.35} do
    local strength = cast_of(strong, seconds)
    expect_near(strength, seconds < 1 and 1.4 or 1, 1e-9, "a tenth of the forces")
end
