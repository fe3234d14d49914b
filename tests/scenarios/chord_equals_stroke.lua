-- A key chord casts the same spell as the stroke, gently or harshly, for the same focus.
match {players = {"script", "script"}, set = {"casting.focus.regain_per_s=0"}}
local drawer, presser = wizard(1), wizard(2)
local function equal(shape, slot, seconds, harsh)
    drawer:cast(shape, {seconds = seconds})
    local drawn = expect_event {kind = "cast", by = 1, within = 0.1}
    presser:chord(slot, harsh)
    local pressed = expect_event {kind = "cast", by = 2, within = 0.1}
    expect_near(pressed.detail, drawn.detail, 0, shape .. ": the same spell")
    expect_near(pressed.amount, drawn.amount, 0, shape .. ": as strongly")
    expect_near(presser:focus(), drawer:focus(), 0, shape .. ": for the same focus")
end
equal("circle", 1, 1.2, false)
expect_near(presser:ward(), drawer:ward(), 0, "equal shields")
wait(7)
equal("circle", 1, 0.3, true)
expect_near(presser:ward(), 42, 1e-9, "a harsh shield")
expect_near(drawer:ward(), 42, 1e-9, "a harsh shield")
equal("s", 3, 1.2, false)
expect(#fogs() == 2, "two clouds")
expect_near(fogs()[1].radius, fogs()[2].radius, 0, "of one size")
-- The key of a chord selects no wand, and the stroke that is drawn meanwhile is not read.
expect(#events {kind = "unread"} == 0, "the hand at rest means nothing else")
local before = presser:shots()
presser:hold("fire")
wait(0.3)
presser:release("fire")
expect(presser:shots() > before, "the first wand is still in hand")
