-- Every bolt kicks the hand of its shooter and no other hand. The kick is half a sine wave of 1.2 N in 15 ms
-- for a device of 3.3 N. The force setting is 45 %.
match {players = {"script", "script"}}
trace("recoil", {"1.force_z", "1.hand_z", "2.force_z"})

local me, foe = wizard(1), wizard(2)
local peak, length = 1.2 * 0.45, 0.015
local impulse, work, felt_by_foe, greatest = 0, 0, 0, 0
local place = me:hand()
local function feel(seconds)
    local last = time() + seconds
    while time() < last do
        tick()
        local force, now = me:force(), me:hand()
        impulse = impulse + force.z * 0.001
        work = work + force.z * (now.z - place.z)
        place = now
        greatest = math.max(greatest, force.z)
        felt_by_foe = felt_by_foe + math.abs(foe:force().z)
        expect_near(force.x, 0, 0)
        expect_near(force.y, 0, 0)
    end
end

me:look(0, 40)
feel(0.2)
expect_near(impulse, 0, 0, "no impulse without a shot")
me:hold("fire")
feel(2)
me:release("fire")
feel(0.2)

local shots = me:shots()
expect(shots >= 16, "8 shots a second")
expect_near(impulse, shots * 2 / math.pi * peak * length, 1e-12, "impulse of 2/pi x peak x length per shot")
expect_near(greatest, peak, 0.002 * peak, "peak force towards the user")
expect_near(felt_by_foe, 0, 0, "no force on the other hand")
expect(me:hand().z > 0 and me:hand().z < 0.002, "the hand gave way a little")
-- The hand takes up at most the energy of a free mass: 150 g of the hand and 45 g of the device.
local kick = 2 / math.pi * peak * length
expect(work > 0 and work < shots * kick * kick / (2 * 0.195), "the hand took up no more energy than a free mass")
