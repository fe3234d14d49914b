-- A circle of a pad's stick, while Trace is held, casts a shield. A quick one is harsh.
match {players = {"script", "script"}}
local me = wizard(1)
local function circle(seconds)
    me:hold("trace")
    for i = 1, 60 do  -- the way to the rim is no part of the stroke
        me:stick(0, i / 60)
        tick()
    end
    local steps = math.floor(1000 * seconds)
    for i = 1, steps do
        local a = 2 * math.pi * i / steps
        me:stick(math.sin(a), math.cos(a))
        tick()
    end
    wait(0.03)
    me:release("trace")
    wait(0.02)
    me:stick(0, 0)
    wait(0.1)
end
circle(1.2)
expect_near(expect_event({kind = "cast", by = 1, within = 0.1}).amount, 1, 0, "a slow circle is gentle")
expect_near(me:ward(), 30, 0, "a shield")
wait(7)
circle(0.45)
expect_near(expect_event({kind = "cast", by = 1, within = 0.1}).amount, 1.4, 1e-9, "a quick one is harsh")
