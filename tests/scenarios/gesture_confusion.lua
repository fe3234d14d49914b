-- Strokes of generated users, drawn with the mouse of a match's hand: at least 95 % are read right, and at most 5 % of
-- scribbles mean anything. Users differ in size, tilt, slant, corners, pace and where figures begin.
match {players = {"script", "script"}, set = {"casting.focus.cap=0", "quick.seconds=3600"}}
local me = wizard(1)
-- The reading of a stroke. The hand comes to rest before it.
local function reading_of(stroke)
    wait(0.2)
    me:trace_over(stroke)
    return me:reading()
end
local right, strokes, meant, scribbles = 0, 0, 0, 0
local classes, efforts = {gentle = 0, harsh = 0}, {gentle = 0, harsh = 0}
for user = 1, 24 do
    for i, figure in ipairs {"circle", "v", "s", "star"} do
        local effort = (user + i) % 2 == 0 and "gentle" or "harsh"
        local read = reading_of(generated_stroke(figure, user, i, effort))
        strokes = strokes + 1
        if read.gesture == figure then right = right + 1 end
        efforts[effort] = efforts[effort] + 1
        if (effort == "harsh") == (read.force >= 1.5) then classes[effort] = classes[effort] + 1 end
    end
    for i = 1, 3 do
        local read = reading_of(generated_stroke("scribble", user, 10 + i, "normal"))
        scribbles = scribbles + 1
        if read.gesture then meant = meant + 1 end
    end
end
expect(right >= 0.95 * strokes, right .. " of " .. strokes .. " strokes are right")
expect(meant <= 0.05 * scribbles, meant .. " of " .. scribbles .. " scribbles mean something")
for effort, count in pairs(efforts) do
    expect(classes[effort] >= 0.95 * count, classes[effort] .. " of " .. count .. " strokes are " .. effort)
end
