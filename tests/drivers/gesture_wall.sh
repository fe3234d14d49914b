#!/usr/bin/env bash
# tests/drivers/gesture_wall.sh THAUM PRESS_KEYS: the gesture wall of the range under Xvfb with real mouse strokes. A player
# draws a V three times for the circle, which is refused as a copy of the game's V, then at once a corner three times. It
# is saved in the profile, and the next match uses it and has it in its log, which replays after the profile is deleted.
# Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 press_keys=$2
need Xvfb xdotool
open_screen 1280x720
few_pictures
fail() { failed "$1"; }
at_failure() { cat "$folder/said"; picture failed; }
drawn() { [ "$(colours 400x100+100+500)" -gt 100 ]; }
# The wall covers the left of the picture by a dark plate.
wall() { [[ $(mean 200x18+100+538) == \#[0-2]?[0-2]?[0-3]? ]]; }
# stroke DX DY STEPS...: draws one straight line for each three numbers, in STEPS steps of DX and DY counts,
# with Trace (the right button) held. It takes about a second.
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
# said WORDS: tests whether the program has printed WORDS about a gesture on the wall.
said() { grep -q "^gesture wall: $1" "$folder/said"; }
# pause ROW [at_once]: pauses the range, chooses ROW, and waits until the range goes on. With at_once, the
# pause must open at that row.
pause() {
    presses Escape
    eventually "no pause of the range" paused
    [ -z "${2:-}" ] || eventually "the pause does not open at '$1'" on_row "$1"
    choose "$1"
    presses Return
    eventually "the pause is still there" no_pause_menu
}
# record WORDS DX DY STEPS...: draws strokes until the wall says WORDS about the gesture that is recorded. A
# stroke that a busy machine takes in at once does not count. A stroke that was begun before the verdict on
# three strokes is the first of the next three.
record() {
    local words=$1 times
    shift
    eventually "no wall" wall
    for times in {1..60}; do
        stroke "$@"
        if said "$words"; then return; fi
    done
    fail "60 strokes, and no word of: $words"
}
own=$XDG_CONFIG_HOME/thaum/gestures/player-1/circle.toml

# 1. A copy of another gesture is refused with its likeness in percent, and another shape is saved without a
# further key. The next pause opens at the row that gives the recording up.
"$thaum" range --seconds 600 >"$folder/said" 2>&1 &
game=$!
eventually "no window" drawn
pause 'Own gesture'
pause 'Give up drawing Circle' at_once
pause 'Own gesture' at_once
record 'not saved, since it is too like V: [0-9]* % of ' 13 31 22 13 -31 22
[ ! -e "$own" ] || fail "a copy of V is saved"
record 'saved: this is your Circle' 0 -22 30 -16 0 30
sleep 0.5
picture gesture_wall
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
