#!/usr/bin/env bash
# tests/drivers/menu.sh THAUM PAD_HARNESS LOG_PROBE PRESS_KEYS: start screen, pause and settings under Xvfb, with keys
# and mouse by xdotool and a pad by umockdev. A keyboard and a pad join and start a duel with three presses. A
# key is bound on the screen, works at once, and still works after a restart. The pad is unplugged, and its
# player goes on with the keypad and then with the pad again. A broken settings file stays unchanged. Exits
# with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 harness=$2 probe=$3 press_keys=$4
need Xvfb xdotool umockdev-wrapper
open_screen 1280x720
settings=$XDG_CONFIG_HOME/thaum/settings.toml
# Asks for few pictures as few_pictures does, but in a copy of the shipped settings file with its comments.
mkdir -p "$XDG_CONFIG_HOME/thaum"
sed 's/^quality = [^ ]*/quality = "low"/; s/^frames_per_second = [^ ]*/frames_per_second = 10/; s/^countdown_s = [^ ]*/countdown_s = 0/' \
    "$(dirname "$0")/../../assets/settings.toml" >"$settings"
matches=$XDG_DATA_HOME/thaum/matches
fail() { failed "$1"; }
at_failure() { picture failed; }

drawn() { [ "$(colours 400x100+100+500)" -gt 100 ]; }
# A seat that is taken has a bar at its left in its team's light colour.
seat_taken() {
    local colour
    colour=$(mean "1x1+$1+127") || return 1
    ((213 * 0x${colour:1:2} + 715 * 0x${colour:3:2} + 72 * 0x${colour:5:2} >= 450 * 255))
}
# quits: leaves the start screen by its last row.
quits() { choose Quit Up && presses Return; }
logs() { find "$matches" -name '*.thaumlog' 2>/dev/null | wc -l; }
has_logs() { [ "$(logs)" -ge "$1" ]; }
pad() { echo "$@" >&4; }
field() { sed -n "s/^device $1:.* $2 \\(.*\\)/\\1/p" <<<"$seen" | cut -d' ' -f1; }
# logged DEVICE FIELD VALUE: tests whether the log that is being written has this input. Inputs are held until then,
# because a slow machine looks at a pad only every few seconds.
logged() {
    seen=$("$probe" "$(find "$matches" -name '*.thaumlog')" --input 2>/dev/null) || true
    [ "$(field "$1" "$2")" = "$3" ]
}

# 1. Keyboard and pad join. A second press of one of them starts the match.
mkfifo "$folder/pad"
umockdev-wrapper "$harness" "$thaum" 4>&- <"$folder/pad" >"$folder/said" 2>&1 &
game=$!
exec 4>"$folder/pad"
eventually "no start screen" drawn
# S and W move through the rows and do not join. Back on the first row, the keyboard joins.
moves_on s s w w
! seat_taken 213 || fail "a key that moves has joined"
presses x
eventually "the keyboard did not join" seat_taken 213
pad a 1
eventually "the pad did not join" seat_taken 650
pad a 0
[ "$(logs)" = 0 ] || fail "a match before anybody started one"
presses x
eventually "no match after three presses" has_logs 1

# 2. The pad is unplugged, which pauses the match. Its player goes on with the keypad, then with the pad.
xdotool keydown w
pad rt 255
eventually "the key W" logged 0 forward 0..127
eventually "the pad's trigger" logged 1 trigger 255
pad rt 0
xdotool keyup w
pad plugged 0
eventually "no pause when the pad was pulled out" pause_menu
presses KP_0
eventually "the keypad did not rejoin" no_pause_menu
xdotool keydown KP_8
eventually "the keypad's 8 after the pad was lost" logged 1 forward 0..127
xdotool keyup KP_8
pad plugged 1
# The player's pad is taken again at a press of its button. The stick is pushed between presses.
takes_pad() {
    pad b 1
    sleep 0.2
    pad b 0
    pad lx 32767
    sleep 0.5
    logged 1 strafe 0..127
}
eventually "the pad's stick after it came back" takes_pad
pad lx 0

# 3. In the pause menu: another key for "move forward", and the other split of the window.
presses Escape
eventually "no pause" pause_menu
choose Controls
moves_on Return Return
choose 'Move forward'
moves_on Return
presses i
eventually "the new key is not in the settings" grep -q '^move_forward = "key i"$' "$settings"
moves_on Escape Escape
choose Settings
moves_on Return
choose Split
presses Right
eventually "the split is not in the settings" grep -q '^split = "side_by_side" ' "$settings"
grep -q '# F11 changes it while playing\|F11 changes it' "$settings" || fail "the comments are lost"
# Player 1's viscosity goes down by two steps, and the flow is switched off.
choose 'Forces and body' Up
moves_on Return
choose 'Cauldron feedback'
moves_on Return
choose Viscosity
moves_on Left Left
choose Flow
presses Return
eventually "the fader is not in the settings" grep -q '^viscosity = 0.9 ' "$settings"
eventually "the switch is not in the settings" grep -q '^off = "flow" ' "$settings"
until no_pause_menu; do moves_on Escape; done
presses Escape
eventually "no second pause" pause_menu
presses q
eventually "no start screen after the match" seat_taken 213
quits
exec 4>&-
wait "$game" || fail "the program's exit code"
seen=$("$probe" "$(find "$matches" -name '*.thaumlog')")
echo "$seen"
grep -q 'replay same' <<<"$seen" || fail "the log does not play again"
[ "$(grep -o '^device 1 [lj][a-z]*' <<<"$seen" | xargs)" = "device 1 left device 1 joined" ] ||
    fail "the log does not say when the pad left and its player joined again"

[ "$(field 0 kept_off)" = 0,0,0,0,0,0,0 ] || fail "the header has a fader that was moved later"

# 4. After a restart the new key works, and the match uses the faders.
"$thaum" --solo 1 --seconds 12 --record "$folder/log" 2>"$folder/said" &
game=$!
eventually "no window" drawn
xdotool keydown i
moved() {
    seen=$("$probe" "$folder/log" --input 2>/dev/null) || true
    [ "$(field 0 forward)" = 0..127 ]
}
eventually "the new key after a restart" moved
xdotool keyup i
presses Escape
eventually "no pause" pause_menu
presses q
wait "$game" || fail "the exit code after Q"
seen=$("$probe" "$folder/log")
[ "$(field 0 kept_off)" = 10,100,0,0,0,0,0 ] || fail "the faders after a restart"

# 5. A settings file of another version is reported in one line and kept. The player can still play and change
# settings.
printf 'version = 9\nfuture = 1\n' >"$settings"
cp "$settings" "$folder/kept"
"$thaum" 2>"$folder/said" &
game=$!
eventually "no start screen with broken settings" drawn
choose Settings
moves_on Return Right Escape
choose 'Duel: press any button to join' Up
moves_on Return
presses Return
eventually "no match with broken settings" has_logs 2
presses Escape
eventually "no pause" pause_menu
presses q
eventually "no start screen after the match" seat_taken 213
quits
wait "$game" || fail "the exit code with broken settings"
cmp "$settings" "$folder/kept" || fail "the broken settings were written over"
[ "$(grep -c . "$folder/said")" = 1 ] && grep -q 'kept as it is' "$folder/said" || fail "said: $(cat "$folder/said")"
echo "start screen, pause, settings and a lost pad work"
