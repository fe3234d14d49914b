-- A blast by a wizard with the Lens does a quarter more harm, and a shield takes none of it. Without the Lens
-- the shield takes 30 HP. A bolt with the Lens is held off by the shield all the same.
match {players = {"script", "script"}, seed = 5}
clear_props()
local me, foe = wizard(1), wizard(2)
me:place {-12, 0, 8}
foe:place {-12, 0, 14}
wait(1.6)

local function blast()
    me:press("wand_2")
    me:aim(foe)
    local before = foe:health()
    me:hold("fire")
    wait(0.6)
    me:release("fire")
    expect_event {kind = "blast_hit", subject = 2, within = 2}
    return before - foe:health()
end

-- The harm of one charge, to compare with.
local bare = blast()
expect(bare > 15, "a blast hurts: " .. bare)
give(1, "lens")
expect(carver(1).lens, "the Lens is held")
foe:chord(1)
wait(0.2)
expect(foe:ward() > 25, "the foe has a shield")
local ward = foe:ward()
local with_lens = blast()
expect_near(with_lens, 1.25 * bare, 0.02 * bare, "a quarter more, past the shield")
expect(foe:ward() == ward, "the shield is whole")
expect(#events {kind = "held_off"} == 0, "the shield took nothing")
me:press("wand_1")
me:aim(foe)
me:hold("fire")
expect_event {kind = "held_off", subject = 2, within = 2}
me:release("fire")
