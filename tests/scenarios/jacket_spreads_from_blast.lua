-- A blast that bursts at the left is felt there first, and runs over the body from there.
match {players = {"script", "script"}}
clear_props()
senses {layouts = {"x40"}}
local me, foe = wizard(1), wizard(2)
me:place {0, 0, 12}
me:face(0)
foe:place {-7, 0, 12}
wait(0.3)
foe:press("next_wand")
foe:aim(me)
foe:hold("fire")
wait(1.2)
foe:release("fire")
wait_until(function() return #events {kind = "blast_hit", subject = 1} > 0 end, 3)

-- When each cell is first on (s since the hit).
local start, first_on = time(), {}
for _ = 1, 60 do
    tick(8)
    for i, cell in ipairs(body(1, "x40")) do
        if cell.felt > 0.05 and not first_on[i] then first_on[i] = time() - start end
    end
end
local left, right, n_left, n_right, later = 0, 0, 0, 0, 0
for i, cell in ipairs(body(1, "x40")) do
    local at = first_on[i]
    if at and cell.at.x < -0.05 then left, n_left = left + at, n_left + 1 end
    if at and cell.at.x > 0.02 then right, n_right = right + at, n_right + 1 end
    if at and at > 0.05 then later = later + 1 end
end
log("left", n_left, left / n_left, "right", n_right, n_right > 0 and right / n_right or 0, "later", later)
expect(n_left >= 6, "cells at the left feel it")
expect(later >= 6, "cells feel it more than 50 ms later")
expect(n_right == 0 or right / n_right > left / n_left + 0.03, "it reaches the right later")
