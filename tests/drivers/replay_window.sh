#!/usr/bin/env bash
# tests/drivers/replay_window.sh THAUM PRESS_KEYS: a replay in its window under Xvfb. Keys and mouse move the
# knob of the bar to the end, the beginning and the middle. At its end the replay stays open. Exits with 77 if
# a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 press_keys=$2
need Xvfb xdotool
open_screen 1280x720
few_pictures
at_failure() { cat "$folder/said"; picture failed; }
# knob_at X: tests whether the bar's knob, which is higher than its line, is at this place.
knob_at() { [[ $(mean "1x1+$1+678") == \#F?F?F? ]]; }
knob_has_left() { ! knob_at "$left"; }
left=13 middle=640 right=1267

bar_is_drawn() { [ "$(mean 1x1+4+655)" = '#0A0614' ]; }

"$thaum" --headless --seconds 10 --record "$folder/log" --out "$folder/out" >/dev/null
# A quarter of the speed: on a busy machine the replay may go on for a while between two keys.
"$thaum" replay "$folder/log" --speed 0.25 >"$folder/said" 2>&1 &
game=$!
eventually "no bar" bar_is_drawn
presses End
eventually "End does not go to the end" knob_at $right
# A step back pauses, so the knob stays where Home takes it. Only states that stay can be waited for.
presses comma Home
eventually "Home does not go to the beginning" knob_at $left
presses space
eventually "Space does not go on" knob_has_left
presses space Home
eventually "Home does not go to the beginning of a paused replay" knob_at $left
sleep 1
knob_at $left || failed "the replay does not pause"
xdotool mousemove $middle 686 mousedown 1
eventually "the mouse does not take the replay to its middle" knob_at $middle
xdotool mouseup 1
presses End
eventually "End does not go to the end from the middle" knob_at $right
presses comma
presses Escape
wait "$game" || failed "the exit code of the replay"
[ ! -s "$folder/said" ] || failed "said: $(cat "$folder/said")"
echo "a replay goes where keys and mouse say"
