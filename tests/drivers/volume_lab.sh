#!/usr/bin/env bash
# tests/drivers/volume_lab.sh THAUM PRESS_KEYS: the volume lab under Xvfb with mouse and keys by xdotool. A ball is
# felt, a panel changes the feel, a tool carves, undo and redo act, and body and session are saved and opened again. Esc
# closes a list, and asks before a carved body is lost. The results are read from the trace and the files. Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 press_keys=$2
need Xvfb xdotool
open_screen 1280x720
few_pictures
fail() { failed "$1"; }
at_failure() { cat "$folder/said"; tail -3 "$folder/trace.csv"* || true; picture failed; }
cd "$folder"
"$thaum" lab sphere --count 32 --size 1280x720 --trace "$folder/trace.csv" --save "$folder/body.nrrd" --seconds 6000 >"$folder/said" 2>&1 &
lab=$!
drawn() { [ "$(colours 300x200+500+260)" -gt 50 ]; }
eventually "no window" drawn

# seen LINE CONDITION: tests whether a row of the trace after that line fulfils a condition of awk, in which
# columns are named: $time_s, $changed_voxels, ...
names=time_s,tip_x_m,tip_y_m,tip_z_m,proxy_x_m,proxy_y_m,proxy_z_m,force_x_n,force_y_n,force_z_n,value,changed_voxels,hand_x_m,hand_y_m,hand_z_m,tool,history
trace() { cat "$folder"/trace.csv*; }
rows() { trace | wc -l; }
seen() {
    local condition=$2 i=0 name
    for name in ${names//,/ }; do i=$((i + 1)) condition=${condition//\$$name/\$$i}; done
    trace | awk -F, -v from="$1" "NR > from + 1 && $condition { found = 1 } END { exit !found }"
}
eventually "another header" seen 0 "1"
[ "$(trace | head -1)" = "$names" ] || fail "another header"

pressing='$force_x_n * $force_x_n + $force_y_n * $force_y_n + $force_z_n * $force_z_n > 0.04'
# The hand begins before the ball, and nothing is felt. Beside the ball the wheel takes it back to the depth of the
# middle, which is in the middle of the window; from there the mouse moves it to the surface.
touching() {
    xdotool mousemove 1000 360 sleep 0.3
    for i in $(seq 14); do xdotool click 4 sleep 0.03; done
    for x in 1000 960 930 910 895 880 865 855; do xdotool mousemove $x 360 sleep 0.1; done
}
xdotool mousemove 640 360
eventually "no second of rows" seen 0 '$time_s > 1'
! seen 1 "$pressing" || fail "the hand begins in the ball"
from=$(rows)
touching
eventually "the surface was not felt" seen "$from" "$pressing"

# The key H holds the hand in place while the mouse moves elsewhere, and pressed again gives the hand back to
# it.
held() { trace | tail -1 | awk -F, '{ d = ($2 - '"$1"')^2 + ($3 - '"$2"')^2; exit !(d < 2.5e-5) }'; }
presses h
tip=$(trace | tail -2 | head -1 | cut -d, -f2,3)
xdotool mousemove 900 600 sleep 0.5 mousemove 400 500
from=$(rows)
eventually "no rows of a held hand" seen "$((from + 1000))" 1
held ${tip/,/ } || fail "the mouse moves the hand that H holds"
xdotool mousemove 855 360 sleep 0.3
presses h

# A tool held for a while carves. Undo brings back what it took away, and redo removes it again.
from=$(rows)
xdotool mousedown 1
eventually "nothing was carved" seen "$from" '$changed_voxels > 20'
xdotool mouseup 1
picture volume_lab
plotted() { [ "$(colours 300x60+20+58)" -gt 2 ]; }
eventually "the force was not plotted" plotted
presses z
presses y

# The panel: its third heading folds the modes away, the next one opens the feel of the body, and the first button there
# adds opacity. The hand rests while the mouse is over the panel.
click() { xdotool mousemove "$1" "$2" sleep 0.3 mousedown 1 sleep 0.3 mouseup 1 sleep 0.3; }
panel() { pixels 330x570+8+130 | md5sum; }
is_new() { [ "$(panel)" != "$before" ]; }
# Each picture shows another time at the lower right. What the mouse does shows in the second new picture at
# the latest.
clock() { pixels 420x60+850+650 | md5sum; }
ticked() { [ "$(clock)" != "$time" ]; }
new_picture() { time=$(clock); eventually "no new picture" ticked; }
settled() {
    local now
    new_picture
    new_picture
    now=$(panel)
    new_picture
    [ "$now" = "$(panel)" ]
}
changes() { before=$(panel); xdotool "$@"; eventually "the panel did not change" is_new; eventually "the panel does not rest" settled; }
pressed_there() {
    xdotool mousemove "$1" "$2"
    eventually "the panel does not rest" settled
    changes mousedown 1
    changes mouseup 1
    xdotool mousemove 640 690
    eventually "the panel does not rest" settled
}
# Ctrl and a click on the felt level let it be typed; the drawn level is the same one.
xdotool mousemove 100 472 keydown ctrl
eventually "the panel does not rest" settled
changes mousedown 1
xdotool mouseup 1 sleep 0.3 keyup ctrl
presses 6 0 Return
eventually "the panel does not rest" settled
pressed_there 26 258
pressed_there 26 282
pressed_there 40 304
picture volume_lab_panel
# "save session" stands at the end of the panel, whatever is open above.
click 60 634
eventually "the session was not saved" test -s "$folder/lab.toml"
grep -q '^kind = "opacity"' "$folder/lab.toml" || fail "the session lacks the feel that was chosen"
[ "$(grep -c '^level = 60$' "$folder/lab.toml")" = 2 ] || fail "felt and drawn level are not the one that was typed"
presses Escape
wait "$lab" || fail "the exit code"

# The saved file opens as the same body, and the session has the same settings.
[ -s "$folder/body.nrrd" ] || fail "the body was not saved"
"$thaum" lab "$folder/body.nrrd" --headless --seconds 0.001 >"$folder/again" || fail "the saved body does not open"
"$thaum" lab "$folder/body.nrrd" --headless --seconds 0.001 --save "$folder/copy.nrrd" >/dev/null
cmp "$folder/body.nrrd" "$folder/copy.nrrd" || fail "the saved body differs after a second saving"
"$thaum" lab --session "$folder/lab.toml" --headless --seconds 0.5 >/dev/null || fail "the session does not open"
"$thaum" lab sphere --count 32 --headless --seconds 0.001 --save "$folder/whole.nrrd" >/dev/null
! cmp -s "$folder/body.nrrd" "$folder/whole.nrrd" || fail "the saved body is not carved"

# Esc closes a list that is open, and asks before a carved body is lost. A click on the middle answer leaves.
rm "$folder"/trace.csv*
"$thaum" lab sphere --count 32 --size 1280x720 --trace "$folder/trace.csv" --seconds 6000 >"$folder/said" 2>&1 &
lab=$!
goes_on() {
    kill -0 "$lab" 2>/dev/null || fail "Esc ended the program"
    [ "$(rows)" -gt $((from + 300)) ]
}
eventually "no second window" drawn
eventually "no rows" seen 0 "1"
# A list looks the same while the button is held on it, and opens when the button is released.
xdotool mousemove 150 162
eventually "the panel does not rest" settled
xdotool mousedown 1 sleep 0.3
changes mouseup 1
presses Escape
from=$(rows)
eventually "no rows after Esc" goes_on
from=$(rows)
touching
xdotool mousedown 1
eventually "nothing was carved again" seen "$from" '$changed_voxels > 20'
xdotool mouseup 1
presses Escape
from=$(rows)
eventually "no rows after the question" goes_on
picture volume_lab_question
xdotool mousemove 650 370 sleep 0.3 mousedown 1 sleep 0.3 mouseup 1
wait "$lab" || fail "the exit code after the question"

# A file with time holds a ball that grows in three steps. Its slider is pulled to the end, which shows the
# last ball.
{
    printf '%s\n' NRRD0005 'type: uchar' 'dimension: 4' 'sizes: 8 8 8 3' 'kinds: domain domain domain time' 'encoding: ascii' ''
    awk 'BEGIN { for (t = 1; t <= 3; t++) for (i = 0; i < 512; i++) {
        x = i % 8 - 3.5; y = int(i / 8) % 8 - 3.5; z = int(i / 64) - 3.5
        print x * x + y * y + z * z < 5 * t ? 200 : 0 } }'
} >"$folder/time.nrrd"
"$thaum" lab "$folder/time.nrrd" --size 1280x720 --seconds 6000 >"$folder/said_of_time" 2>&1 &
timed_lab=$!
eventually "no window with time" drawn
xdotool mousemove 40 210
eventually "the panel does not rest" settled
xdotool mousedown 1 sleep 0.3 mousemove 130 210 sleep 0.3
changes mousemove 210 210
changes mouseup 1
rm -f "$folder/lab.toml"
click 60 634
eventually "the session with a moment was not saved" test -s "$folder/lab.toml"
grep -q '^moment = 3$' "$folder/lab.toml" || fail "the slider does not choose the moment"
presses Escape
wait "$timed_lab" || fail "the exit code with time"

# What a hand did in the window, its tool too, is played again from the trace and leads to the same trace.
ticks=$(($(rows) - 1))
"$thaum" lab sphere --count 32 --headless --hand "$folder/trace.csv" --trace "$folder/again.csv" \
    --seconds $((ticks / 1000)).$(printf %03d $((ticks % 1000))) >/dev/null || fail "the trace does not lead the hand"
cmp "$folder/trace.csv" "$folder/again.csv" || fail "the trace played again differs"
echo "passed"
