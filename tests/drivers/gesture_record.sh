#!/usr/bin/env bash
# tests/drivers/gesture_record.sh THAUM FAKE_HD: `thaum gesture record` in a window under Xvfb. Three circles are drawn
# with the mouse and three by a fake arm; both files must be gestures that do not collide with the shipped V, S and star,
# and a mouse's circle must be read as the arm's. A stroke is taken back, and a window is left. Exits with 77 if a tool is
# missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 fake=$2
gestures=$(readlink -f "$(dirname "$0")/../../assets/gestures")
need Xvfb xdotool
open_screen 1280x720
few_pictures
fail() { failed "$1"; }
at_failure() { cat "$folder/said"; picture failed; }
# Tests whether the title of the window is drawn: words on the dark ground.
drawn() { [ "$(colours 600x60+340+30)" -gt 10 ]; }
head() { pixels 600x60+340+30 | md5sum; }
changed() { [ "$(head)" != "$before" ]; }
# counts: waits until the title counts another stroke.
counts() { eventually "a stroke was not counted" changed; before=$(head); }
# circle BUTTON: a circle of 3 cm radius in about a second, begun and ended slowly as hands do.
circle() {
    xdotool mousedown "$1" $(awk 'BEGIN {
        for (i = 1; i <= 60; i++) {
            u = i / 60; a = 6.2832 * u * u * u * (10 - 15 * u + 6 * u * u)
            x = int(300 * cos(a) + 300.5); y = int(300 * sin(a) + 300.5)
            if (i == 1) { px = 600; py = 300 }
            printf "mousemove_relative -- %d %d sleep 0.016 ", x - px, y - py
            px = x; py = y
        }
    }') mouseup "$1"
}
# record WORDS...: starts the program, with its window.
record() { "$thaum" gesture record "$@" >"$folder/said" 2>&1 & program=$!; eventually "no window" drawn; before=$(head); }

# 1. Four strokes by mouse, of which one is taken back. A click before them is no stroke, and the window says so.
record circle --closed --any-direction --rotation 180 --planar --out "$folder/circle.toml"
note() { [ "$(colours 900x30+190+98)" -gt 10 ]; }
! note || fail "a note before the first stroke"
xdotool mousedown 1 sleep 0.3 mouseup 1
eventually "no word of a click" note
picture gesture_record_click
! changed || fail "a click was counted"
circle 1
counts
circle 3
counts
xdotool key BackSpace
counts
circle 3
picture gesture_record
counts
[ ! -e "$folder/circle.toml" ] || fail "the file is written before the last stroke"
circle 1
wait "$program" || fail "the exit code"
grep -q "^3 strokes of 'circle'$" "$folder/said" || fail "other words than '3 strokes'"
"$thaum" gesture check "$folder/circle.toml" "$gestures"/{v,s,star}.toml || fail "the mouse's circle collides"
if "$thaum" gesture check "$folder/circle.toml" "$gestures/circle.toml" >"$folder/said"; then
    fail "the mouse's circle is another gesture than the shipped one"
fi
# 600 counts of the mouse are 6 cm, drawn against a viscous field of 3.5 N s/m.
awk -F'[][,]' '/^\[\[stroke/ { strokes++ } /^[xyft]/ { column = $1 } { gsub(/[a-z =]/, "")
    for (i = 1; i <= NF; i++) if (column ~ /^x/ && $i != "") { if ($i < low) low = $i; if ($i > high) high = $i }
} END { exit !(strokes == 3 && high - low > 0.05 && high - low < 0.08) }' "$folder/circle.toml" || fail "circles of another size"

# 2. The window is left before the first stroke, so no file is written.
"$thaum" gesture record v --out "$folder/v.toml" >"$folder/said" 2>&1 &
program=$!
leaves() { xdotool key Escape; ! kill -0 "$program" 2>/dev/null; }
eventually "Escape does not leave" leaves
if wait "$program"; then fail "a window that was left gives a gesture"; fi
grep -q 'closed before all strokes' "$folder/said" || fail "no word of the strokes that are missing"
[ ! -e "$folder/v.toml" ] || fail "a file of no stroke"

# 3. An arm whose hand draws circles while its button is down.
awk 'BEGIN {
    print "0 30 0 0 0"
    for (turn = 0; turn < 8; turn++) for (i = 0; i <= 100; i++) {
        u = i / 100; a = 6.2832 * u * u * u * (10 - 15 * u + 6 * u * u)
        printf "%d %.2f %.2f %.2f %d\n", 2000 + turn * 1500 + i * 10, 30 * cos(a), 30 * sin(a), 4 * sin(a), (i > 0 && i < 100)
    }
}' >"$folder/path"
THAUM_LIBHD=$fake FAKE_HD="path=$folder/path,live=$folder/arm.live" "$thaum" gesture record ring --device touch \
    --closed --any-direction --rotation 180 --planar --out "$folder/ring.toml" >"$folder/said" 2>&1 || fail "the exit code of the arm"
grep -q "^3 strokes of 'ring'$" "$folder/said" || fail "other words than '3 strokes'"
[ "$(live arm 5 u8)" = 0 ] || fail "the program still has the arm"
awk -v most="$(live arm 3 f8)" 'BEGIN { exit !(most > 0.2 && most < 1.6) }' || fail "a force of $(live arm 3 f8) N against the hand"
"$thaum" gesture check "$folder/ring.toml" "$gestures"/{v,s,star}.toml || fail "the arm's circle collides"
if "$thaum" gesture check "$folder/ring.toml" "$folder/circle.toml" >"$folder/said"; then fail "mouse and arm draw different circles"; fi
THAUM_LIBHD=$fake FAKE_HD=absent "$thaum" gesture record ring --device touch --out "$folder/none.toml" >"$folder/said" 2>&1 &&
    fail "an arm that is not there draws"
grep -q '^thaum: --device touch' "$folder/said" || fail "no word of the missing arm"
echo "three circles by mouse and three by an arm"
