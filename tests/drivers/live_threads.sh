#!/usr/bin/env bash
# tests/drivers/live_threads.sh THAUM FAKE_HD LOG_PROBE PRESS_KEYS: all threads of a live session at once, for
# the thread sanitizer: a match under Xvfb with an arm whose libHD.so is our fake, against a bot, recorded. Keys
# and mouse by xdotool pause it, open a page of settings, mark the log and quit. The log must replay with the
# arm's forces. Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 fake=$2 probe=$3 press_keys=$4
need Xvfb xdotool
open_screen 1280x720
few_pictures
at_failure() { cat "$folder/said"; picture failed; }

# The hand holds still, then moves to and fro with the button held, so that each shot kicks.
awk 'BEGIN {
    print 0, 0, 0, 0, 0; print 300, 0, 0, 0, 1
    for (ms = 320; ms <= 600000; ms += 20) print ms, 20 * sin((ms - 300) / 400), 5 * sin((ms - 300) / 150), 0, 1 }' >"$folder/way"
THAUM_LIBHD=$fake FAKE_HD="path=$folder/way,live=$folder/live" "$thaum" --solo 1 --hands arm --seed 1 --seconds 600 \
    --set bolt.shot.damage=1 --record "$folder/log" >"$folder/said" 2>&1 &
game=$!
# The fourth number of FakeHdLive is the strongest force so far.
is_felt() { od -An -v -tf8 -j24 -N8 "$folder/live" 2>/dev/null | awk '{ exit !($1 > 0.3) }'; }

eventually "no shot is felt" is_felt
xdotool keydown w
for _ in $(seq 10); do xdotool mousemove_relative -- 12 -3; done
presses F3 F10 F6
xdotool keyup w
presses Escape
eventually "no pause" pause_menu
# Opens a page of the menu and presses a key on it, then goes on with the match.
presses Down Return Right Escape Escape
eventually "Esc did not go on" no_pause_menu
presses Escape
eventually "no second pause" pause_menu
presses q
wait "$game" || failed "the session's exit code"
cat "$folder/said"
grep -q '^arm: [0-9]* ticks.*; 0 forces differ' "$folder/said" || failed "the match computes other forces than the arm's thread"
"$probe" "$folder/log" || failed "the log does not play again"
echo "a live session with an arm was played, paused and recorded"
