-- Stirring in circles makes the brew turn that way.
match {players = {"script", "script"}}
clear_props()
local me = wizard(1)
me:place {-2.2, 0, 0}
wait(0.2)
me:hold("stir")
wait(0.3)
expect(me:stirs(), "at the rim, with stir held")
log(me:ladle().x, me:ladle().y, me:ladle().z)
local t0 = time()
for i = 1, 3000 do
    local a = 2 * math.pi * i / 1000
    -- 5 cm of the device's hand: 0.1 mm a count
    me:stroke(math.floor(3 * math.cos(a) + 0.5), math.floor(3 * math.sin(a) + 0.5))
    wait(0.001)
    if i % 250 == 0 then
        local b = brew()
        log(i, b.speed, length(me:force()), length(me:ladle_force()), me:ladle().x, me:ladle().y, me:ladle().z)
    end
end
expect(brew().speed > 5)
