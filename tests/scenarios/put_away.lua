-- A wizard puts a carried ingredient away by Throw: anywhere, and at another niche in exchange for what lies there. At a
-- niche, a wizard with full hands is told so. A thing that the wand holds is thrown first.
match {players = {"script", "script"}, set = {"cauldron.brew.cells_across=10"}}
clear_props()
local me = wizard(1)
wizard(2):place {15, 0, -15}
local ember, salt, aside = {-4.5, 0, 0}, {4.5, 0, 0}, {0, 0, 12}
local function count(kind) return #events {kind = kind, by = 1} end
local function newest(kind)
    local all = events {kind = kind, by = 1}
    return all[#all].with
end

me:place(ember)
wait(0.1)
expect(count("ingredient") == 1 and newest("ingredient") == "ember", "the hands were empty")
expect(count("hands_full") == 0, "its own niche says nothing")

-- Full hands at another niche: told once for each visit.
me:place(salt)
wait(0.5)
expect(count("ingredient") == 1, "the hands are full")
expect(count("hands_full") == 1 and newest("hands_full") == "salt", "and that is told")
me:place(aside)
wait(0.1)
me:place(salt)
wait(0.1)
expect(count("hands_full") == 2, "told again at the next visit")

-- Throw at another niche exchanges the ingredient for what lies there.
me:press("throw", 0.05)
wait(0.05)
expect(count("put_away") == 1 and newest("put_away") == "ember", "the ember is put away")
expect(count("ingredient") == 2 and newest("ingredient") == "salt", "the salt is taken")

-- At its own niche the salt is not taken up again at once.
me:press("throw", 0.05)
wait(1.5)
expect(count("put_away") == 2 and newest("put_away") == "salt", "the salt is put away")
expect(count("ingredient") == 2, "and stays in its niche")
wait(0.7)
expect(count("ingredient") == 3, "it lies there again after 2 s")

-- Throw anywhere else. Both ingredients are back in their niches, long before the 8 s after they were taken.
me:place(aside)
me:press("throw", 0.05)
expect(count("put_away") == 3, "put away far from all niches")
me:press("throw", 0.05)
expect(count("put_away") == 3, "empty hands have nothing to put away")
wait(2.1)
me:place(salt)
wait(0.1)
expect(count("ingredient") == 4 and newest("ingredient") == "salt", "the salt is back")

-- Throw at the rim, with the ladle in hand, puts the ingredient away. With fire in the same moment it falls
-- into the brew instead.
me:place {2.2, 0, 0}
me:hold("stir")
wait(0.2)
expect(me:stirs(), "at the rim")
me:press("throw", 0.05)
wait(0.1)
expect(count("put_away") == 4 and me:stirs(), "put away while stirring")
me:release("stir")
me:place(ember)
wait(0.1)
expect(newest("ingredient") == "ember", "the ember is back")
me:place {-2.2, 0, 0}
me:hold("stir")
wait(0.2)
me:hold("fire")
me:hold("throw")
wait(0.1)
me:release("fire")
me:release("throw")
me:release("stir")
expect(count("dropped") == 1 and count("put_away") == 4, "dropped in, not put away")

-- A thing that the wand holds is thrown, and the ingredient stays.
wait(2)
me:place(salt)
wait(0.1)
expect(count("ingredient") == 6, "salt in the hand")
me:place {0, 0, 19}
me:face(90, 0)
local ball = spawn {kind = "sphere", radius = 0.25, mass = 12, at = {-3, 0.25, 19}}
wait(0.3)
me:press("wand_4")
me:aim(ball)
me:hold("fire")
wait(0.5)
me:press("throw", 0.05)
wait(0.1)
me:release("fire")
expect(length(ball:velocity()) > 5, "the ball is thrown")
expect(count("put_away") == 4, "the salt stays in the hand")
me:press("throw", 0.05)
expect(count("put_away") == 5, "until the next press")
