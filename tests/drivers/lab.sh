#!/usr/bin/env bash
# tests/drivers/lab.sh THAUM PRESS_KEYS: the lab under Xvfb with mouse and keys by xdotool. The brew is stirred and
# poured into, solver and grid change while it moves, and it is saved and loaded. The results are read from
# the trace and the saved state. Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 press_keys=$2
need Xvfb xdotool
open_screen 1280x720
few_pictures
fail() { failed "$1"; }
at_failure() { cat "$folder/said"; tail -3 "$folder/trace.csv"* || true; picture failed; }
drawn() { [ "$(colours 300x200+200+100)" -gt 100 ]; }
"$thaum" lab --fluid --size 640x360 --cells 24 --trace "$folder/trace.csv" --save "$folder/brew" --seconds 600 >"$folder/said" 2>&1 &
lab=$!
eventually "no window" drawn
# The figures on the screen change with every picture. A key takes effect at the latest in the second new
# picture.
drawing() { pixels 640x360+0+0 | md5sum; }
is_new() { [ "$(drawing)" != "$before" ]; }
new_picture() { before=$(drawing); eventually "no new picture" is_new; }
key() { presses "$@"; new_picture; new_picture; }
stir() {
    for i in $(seq 12); do
        xdotool mousemove $((320 + (i % 4 - 2) * 30)) $((180 + (i / 4 - 1) * 20))
        sleep 0.05
    done
}

# Stirs and pours, then lets go. Changes to the other solver, to a finer grid, and back to the first solver.
xdotool mousemove 320 180 mousedown 1 keydown space
stir
xdotool keyup space
stir
picture lab
xdotool mouseup 1
key s
key equal
key s
key F5
eventually "F5 did not save" test -s "$folder/brew"
key BackSpace
for _ in 1 2 3 4 5; do  # pressed and released within one picture
    key space
done
key F9
presses Escape
wait "$lab" || fail "the exit code"

column() { head -1 "$folder/trace.csv" | tr , '\n' | grep -nx "$1" | cut -d: -f1; }
moved=$(awk -F, -v e="$(column energy_m5_s2)" 'NR > 1 && $e > most { most = $e } END { print (most > 1e-4) }' "$folder/trace.csv")
[ "$moved" = 1 ] || fail "the mouse moved nothing"
grids=$(awk -F, -v c="$(column cells)" -v s="$(column substeps)" 'NR > 1 && $s > 0 { seen[$c / $s] = 1 } END { for (n in seen) print n }' "$folder/trace.csv" | wc -l)
[ "$grids" -ge 2 ] || fail "the grid did not change"
poured=$(awk -F, -v p="$(column substance_1_m3)" 'END { print ($p > 0.01) }' "$folder/trace.csv")
[ "$poured" = 1 ] || fail "what was poured is not there after reset and load"
# The rows of the trace between the reset and the load, where the time jumps, must show at least what five
# presses pour, no step that pours more than that, and steps that pour nothing once the key is up. A slow
# machine may take several presses into one step, or a press and its release in two pictures; then the lab
# pours for the steps between them.
tapped=$(awk -F, -v t="$(column time_s)" -v p="$(column substance_1_m3)" '
    NR > 2 && ($t < last || $t > last + 0.02) { if (++jumps == 1) { amount = 0; still = 0 } }
    NR > 1 { last = $t }
    jumps == 1 { rise = $p - amount; if (rise > most) most = rise; still = rise > 1e-5 ? 0 : still + 1
                 if (rise > 0) amount = $p }
    END { print (jumps == 2 && amount > 0.0099 && most < 0.01001 && still > 0) }' "$folder/trace.csv")
[ "$tapped" = 1 ] || fail "five presses did not pour what five steps pour, or poured on"
"$thaum" lab --fluid --headless --stir none --load "$folder/brew" --seconds 0.1 >"$folder/said" || fail "the state does not load"
grep -q '32 cells across, thaum, bowl' "$folder/said" || fail "another solver or grid than was chosen"
# A signal ends the lab as closing its window does.
for room in --fluid "sphere --count 32"; do
    rm -f "$folder"/trace.csv*
    # shellcheck disable=SC2086
    "$thaum" lab $room --size 640x360 --trace "$folder/trace.csv" --seconds 600 >"$folder/said" 2>&1 &
    lab=$!
    eventually "no window" drawn
    kill -TERM "$lab"
    wait "$lab" || fail "the exit code after a signal"
    grep -q '^time_s,' "$folder/trace.csv" || fail "a signal loses the trace of lab $room"
    grep -q 'ended by a signal' "$folder/said" || fail "no word of the signal"
done
echo "stirred, changed, saved and loaded by mouse and keys"
