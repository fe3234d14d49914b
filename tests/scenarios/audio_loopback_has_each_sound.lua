-- Each sound that is played to the loopback device of OpenAL is audible there, and its bands resemble its own
-- recipe more than any other; one sound in twenty may fail. In a match the bolt is heard among its bands, and
-- silence is silent.
match {players = {"script", "script"}}
senses {sound = true}
local me = wizard(1)
local wrong, count = 0, 0
for _, name in ipairs(sounds()) do
    local heard = loopback(name)
    expect(heard.db > -45 and heard.db < 0, name .. " is at " .. heard.db .. " dB")
    count = count + 1
    if heard.like ~= name then
        wrong = wrong + 1
        log(name .. " is taken for " .. heard.like)
    end
end
expect(count > 40, "sounds: " .. count)
expect(wrong <= count / 20, wrong .. " of " .. count .. " are taken for others")

-- The mean level of bands from 300 Hz on, where no calm music is.
local function high_bands(sound)
    local sum, n = 0, 0
    for row = 13, #sound.bands do sum, n = sum + sound.bands[row], n + 1 end
    return sum / n
end
wait(1)
sound()
wait(0.5)
local before = sound()
me:press("fire")
wait(0.5)
local shot = sound()
log("before", high_bands(before), "shot", high_bands(shot))
expect(high_bands(shot) > high_bands(before) + 10, "the bolt is 10 dB above what was there before")
