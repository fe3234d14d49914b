#!/usr/bin/env bash
# tests/drivers/resize.sh THAUM LOG_PROBE: a window that shrinks while the mouse is captured and the pointer lies outside
# of it. The view must not turn, although the pointer is pulled into the window each time. A motion of the mouse must
# still turn it. On a small screen the window opens no larger than the screen. Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 probe=$2
need Xvfb xdotool
open_screen 800x600
few_pictures

"$thaum" --solo 0 --record "$folder/log" >"$folder/said" 2>&1 &
game=$!
look() { "$probe" "$folder/log" --input >"$folder/seen" 2>/dev/null || true; sed -n 's/^device 0: look \([-0-9]* [-0-9]*\) .*/\1/p' "$folder/seen"; }
begun() { [ -n "$(look)" ]; }
eventually "no match" begun
window=$(xdotool search --name '^Thaum$')
size() { xdotool getwindowgeometry "$window" | sed -n 's/.*Geometry: //p'; }
[ "$(size)" = 800x600 ] || failed "on a screen of 800x600 the window has $(size)"
xdotool windowfocus --sync "$window"
for small in 500x400 400x300 300x200; do
    xdotool mousemove 790 590
    xdotool windowsize --sync "$window" "${small%x*}" "${small#*x}"
    [ "$(size)" = $small ] || failed "the window has $(size) and not $small"
    sleep 0.3
done
before=$(look)
moved() {
    xdotool mousemove_relative 12 0
    sleep 0.1
    [ "$(look)" != "$before" ]
}
eventually "the mouse does not turn the view" moved
[ "$before" = "0 0" ] || failed "the view was turned by $before counts"
kill -TERM "$game"
wait "$game" || true
echo "the view stayed where it was"
