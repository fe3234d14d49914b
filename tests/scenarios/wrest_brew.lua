-- Both ladles in: who has done more work in the last second and a half has the brew.
match {players = {"script", "script"}}
clear_props()
local one, two = wizard(1), wizard(2)
two:place {15, 0, -15}
one:place {-4.5, 0, 0}
wait(0.1)
one:place {-2.2, 0, 0}
two:place {2.2, 0, 0}
one:hold("stir") two:hold("stir")
wait(0.3)
one:press("fire")
wait(0.2)
expect(brew().owner == 1, "whose ingredient it is")
local function stir(who, seconds)
    for i = 1, seconds * 1000 do
        local a = 2 * math.pi * i / 800
        who:stroke(math.floor(3 * math.cos(a) + 0.5), math.floor(3 * math.sin(a) + 0.5))
        tick()
    end
end
stir(two, 2)
expect(brew().owner == 2, "who stirs harder")
expect_event {kind = "wrested", by = 2, within = 0.1}
stir(one, 3)
expect(brew().owner == 1, "and back")
