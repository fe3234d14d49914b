#!/usr/bin/env bash
# tests/drivers/pad_duel.sh THAUM PAD_HARNESS LOG_PROBE: a duel under Xvfb with mouse and keys by xdotool
# and a pad by umockdev, which is unplugged and plugged in again. The log must show the input of both players,
# and both halves of the screen must show something. Each step waits until the log shows the step before.
# Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 harness=$2 probe=$3
need Xvfb xdotool umockdev-wrapper
open_screen 1280x720
few_pictures

mkfifo "$folder/pad"
umockdev-wrapper "$harness" "$thaum" --vs --hands mouse,pad --record "$folder/log" 4>&- <"$folder/pad" &
game=$!
exec 4>"$folder/pad"
pad() { local what; for what in "$@"; do echo "$what" >&4; done; }

# look: reads what the log holds so far.
look() { "$probe" "$folder/log" --input >"$folder/seen" 2>/dev/null || true; grep -q '^device 0' "$folder/seen"; }
field() { sed -n "s/^device $1:.* $2 \(.*\)/\1/p" "$folder/seen" | cut -d' ' -f1; }
has() { look && [ "$(field "$1" "$2")" = "$3" ]; }
moved() { look && [ "$(field 1 strafe)" != 0..0 ] && [ "$(field 1 turn)" != 0..0 ]; }
says() { look && grep -q "$1" "$folder/seen"; }
shows() { [ "$(colours "$1")" -gt 200 ]; }

eventually "no match" look
pad 'lx 30000' 'rx 25000' 'rt 255'
eventually "the pad's trigger" has 1 trigger 255
eventually "the pad's sticks" moved
pad 'rt 0' 'lx 0' 'rx 0'
xdotool keydown w
for _ in $(seq 10); do
    xdotool mousemove_relative -- 12 -3
    sleep 0.05
done
xdotool mousedown 1
eventually "the mouse's counts" has 0 look 120
eventually "the key W" has 0 forward 0..127
eventually "the mouse button" has 0 trigger 255
for half in 1280x360+0+0 1280x360+0+360; do
    eventually "half $half of the window shows too few colours" shows $half
done
xdotool mouseup 1 keyup w
pad 'plugged 0'
eventually "no pause when the pad was pulled out" paused
eventually "the log does not say that the pad left" says '^device 1 left at '
pad 'plugged 1'
# A button held while the pad is plugged in does not count as pressed. One that goes down and up does.
rejoins() { pad 'b 1'; sleep 0.2; pad 'b 0'; no_pause_menu; }
eventually "no going on after it was put back" rejoins
eventually "the log does not say that the pad joined again" says '^device 1 joined at '
! says '^device 0 ' || failed "the log says that the mouse left"
pad 'signal 15'
exec 4>&-
wait "$game" || failed "the program's exit code"
"$probe" "$folder/log" >"$folder/seen" || failed "the log does not play again"
cat "$folder/seen"
grep -q '^paused at .* by 1$' "$folder/seen" || failed "not player 2 paused"
grep -q '^on at ' "$folder/seen" || failed "the match did not go on"
echo "both players' input arrived"
