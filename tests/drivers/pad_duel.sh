#!/usr/bin/env bash
# tests/drivers/pad_duel.sh SESSION PAD_HARNESS LOG_PROBE: a window under Xvfb, mouse and keys by xdotool, a pad by
# umockdev that is pulled out and put back. Checks by the log that both players' input arrived, and by a screenshot that
# both halves show something. Exits 77 where a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
session=$1 harness=$2 probe=$3
need Xvfb xdotool import convert umockdev-wrapper
open_screen 1280x720

# Seconds count from the harness' start; the window takes one or two to come, more on a busy machine.
script='6 lx 30000; 6.2 rt 255; 6.4 rx 25000; 8.5 rt 0; 8.5 lx 0; 8.6 rx 0; 9 a 1; 9.3 a 0; 10 plugged 0; 12 plugged 1; 13 b 1; 13.4 b 0'
umockdev-wrapper "$harness" "$script" "$session" "$folder/log" 14 mouse pad &
game=$!
for _ in $(seq 200); do
    xdotool search --name Thaum >/dev/null 2>&1 && break
    sleep 0.05
done
sleep 3.5
xdotool keydown w
for _ in $(seq 10); do
    xdotool mousemove_relative -- 12 -3
    sleep 0.05
done
xdotool mousedown 1
sleep 1
import -window root "$folder/shot.png"
xdotool mouseup 1 keyup w
wait "$game"

seen=$("$probe" "$folder/log")
echo "$seen"
fail() { echo "failed: $1"; exit 1; }
field() { sed -n "s/^device $1:.* $2 \\(.*\\)/\\1/p" <<<"$seen" | cut -d' ' -f1; }
[ "$(field 0 look)" = 120 ] || fail "the mouse's counts"
[ "$(field 0 forward)" = 0..127 ] || fail "the key W"
[ "$(field 0 trigger)" = 255 ] || fail "the mouse button"
[ "$(field 1 trigger)" = 255 ] || fail "the pad's trigger"
[ "$(field 1 strafe)" != 0..0 ] || fail "the pad's left stick"
[ "$(field 1 turn)" != 0..0 ] || fail "the pad's right stick"
grep -q '^paused at .* by 1$' <<<"$seen" || fail "no pause when the pad was pulled out"
grep -q '^on at ' <<<"$seen" || fail "no going on after it was put back"
for half in 1280x360+0+0 1280x360+0+360; do
    colours=$(convert "$folder/shot.png" -crop "$half" -format %k info:)
    [ "$colours" -gt 200 ] || fail "half $half of the window shows $colours colours"
done
echo "both players' input arrived"
