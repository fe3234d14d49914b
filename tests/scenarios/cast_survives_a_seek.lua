-- A seek into the middle of a stroke, of a cloud's time and of a shield's leads to the same state as playing so far.
match {seed = 4, players = {"script", "bot 3"}}
local me = wizard(1)
me:move(0, 1)
wait(1)
me:stop()
local strokes = {}
for _, shape in ipairs {"circle", "s", "v"} do
    local before = now()
    me:cast(shape, {seconds = 1})
    expect_event {kind = "cast", by = 1, within = 0.1}
    strokes[#strokes + 1] = (before + now()) // 2
    wait(1.5)
end
check_seek {ticks = {strokes[1], strokes[2], strokes[3], strokes[2] + 1500, now()}}
