#!/usr/bin/env bash
# tests/drivers/gesture_wall.sh THAUM PRESS_KEYS: the gesture wall of the range under Xvfb with real mouse strokes. A player
# draws a V three times for the circle, which is refused as a copy of the game's V, then a corner three times. It is saved
# in the profile, and the next match uses it and has it in its log, which replays after the profile is deleted. Exits with
# 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 press_keys=$2
need Xvfb xdotool import
open_screen 1280x720
few_pictures
fail() { failed "$1"; }
at_failure() { cat "$folder/said"; import -window root "${SHOTS:-$folder}/failed.png"; }
drawn() { [ "$(import -window root -crop 400x100+100+500 -format %k info: 2>/dev/null)" -gt 100 ]; }
# The wall covers the left of the picture by a dark plate.
wall() { [ "$(import -window root -crop 200x30+100+515 -resize 1x1 -depth 8 txt: 2>/dev/null | grep -c '#[0-2][0-9A-F][0-2][0-9A-F][0-3][0-9A-F]')" = 1 ]; }
# stroke DX DY STEPS...: draws lines of so many steps of DX and DY counts with Trace (the right button) held, in about a
# second.
stroke() {
    xdotool mousedown 3
    sleep 0.2
    xdotool $(awk -v lines="$*" 'BEGIN {
        n = split(lines, line, " ")
        for (i = 1; i < n; i += 3) for (k = 0; k < line[i + 2]; k++)
            print "mousemove_relative --", line[i], line[i + 1], "sleep 0.016"
    }')
    sleep 0.2
    xdotool mouseup 3
    sleep 0.2
}
# said COUNT: tests whether the wall has told so many times what became of a gesture.
said() { [ "$(grep -c '^gesture wall: ' "$folder/said")" = "$1" ]; }
# record COUNT DX DY STEPS...: begins a gesture of the player's own by the fifth row of the pause of the range, and draws
# strokes until the wall tells what became of it. A stroke that a busy machine takes in at once does not count.
record() {
    local count=$1 times
    shift
    presses Escape
    eventually "no pause of the range" paused
    presses Down Down Down Down Return
    eventually "the pause is still there" no_pause_menu
    eventually "no wall" wall
    for times in {1..40}; do
        stroke "$@"
        if ((times >= 3)) && said "$count"; then return; fi
    done
    fail "40 strokes made no gesture"
}
own=$XDG_CONFIG_HOME/thaum/gestures/player-1/circle.toml

# 1. A copy of another gesture is refused with a figure, another shape is saved.
"$thaum" range --seconds 600 >"$folder/said" 2>&1 &
game=$!
eventually "no window" drawn
record 1 8 22 22 8 -22 22
grep -q '^gesture wall: not saved: it is too like V: [0-9]* % of ' "$folder/said" || fail "a copy of V is not refused"
[ ! -e "$own" ] || fail "a copy of V is saved"
record 2 0 -22 30 -16 0 30
grep -q '^gesture wall: saved: this is your circle' "$folder/said" || fail "a corner is not saved"
sleep 0.5
import -window root "${SHOTS:-$folder}/gesture_wall.png"
presses Escape
eventually "no second pause of the range" paused
presses q
wait "$game" || fail "the exit code of the range"
[ "$(grep -c '^\[\[stroke\]\]' "$own")" = 3 ] || fail "not three strokes"
"$thaum" gesture check "$own" >"$folder/said" || fail "the saved file is no gesture"

# 2. A match takes the gesture into its log, which needs no profile.
"$thaum" --solo 1 --seconds 2 --record "$folder/log" >"$folder/said" 2>&1 || fail "the exit code of the match"
"$thaum" replay "$folder/log" --header >"$folder/said"
grep -q "^profile data: gesture 'circle' of player 1" "$folder/said" || fail "the log has no gesture of the player"
rm -r "$XDG_CONFIG_HOME/thaum/gestures"
"$thaum" replay "$folder/log" --verify >"$folder/said" || fail "the log does not play again without the profile"
echo "an own gesture was drawn, saved, played with and replayed"
