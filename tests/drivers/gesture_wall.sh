#!/usr/bin/env bash
# tests/drivers/gesture_wall.sh THAUM PRESS_KEYS: the gesture wall of the range under Xvfb with real mouse strokes. A player
# draws a triangle three times for the circle; it is saved in the profile, and the next match uses it and has it in its
# log, which replays after the profile is deleted. Exits with 77 if a tool is missing.
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
# triangle: a triangle with Trace (the right button) held, in about a second.
triangle() {
    xdotool mousedown 3
    sleep 0.2
    xdotool $(awk 'BEGIN { for (i = 0; i < 20; i++) print 12, -22
                           for (i = 0; i < 20; i++) print 12, 22
                           for (i = 0; i < 30; i++) print -16, 0 }' |
        awk '{ printf "mousemove_relative -- %d %d sleep 0.016 ", $1, $2 }')
    sleep 0.2
    xdotool mouseup 3
    sleep 0.2
}
own=$XDG_CONFIG_HOME/thaum/gestures/player-1/circle.toml

# 1. The fifth row of the pause of the range begins a gesture of the player's own.
"$thaum" range --seconds 600 >"$folder/said" 2>&1 &
game=$!
eventually "no window" drawn
presses Escape
eventually "no pause of the range" paused
presses Down Down Down Down Return
eventually "the pause is still there" no_pause_menu
eventually "no wall" wall
for _ in 1 2 3; do triangle; done
saved() { [ -s "$own" ] || { triangle; [ -s "$own" ]; }; }
eventually "the gesture was not saved" saved
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
