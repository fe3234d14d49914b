#!/usr/bin/env bash
# tests/drivers/input_delay.sh SESSION THAUM: the delay from a movement to its picture, measured under Xvfb.
# The figure must be possible, a stalled render thread must raise it, and `thaum doctor` must report it.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
session=$1 thaum=$2
need Xvfb
open_screen 640x360

# delay NAME [STALL...]: sets `median` and `p99` (whole ms), and `slow`: the longest delay of a tick on this
# machine plus the 99th percentile of the times of its pictures (ms).
delay() {
    local name=$1 said
    shift
    said=$("$session" "$folder/$name" 4 probe bot "$@" | grep -E '^(input ms|late us)')
    echo "$name: $said"
    read -r median p99 inputs < <(sed -n 's/^input.*median \([0-9]*\).*p99 \([0-9]*\).* of \([0-9]*\).*/\1 \2 \3/p' <<<"$said")
    slow=$(sed -n 's/.*worst \([0-9]*\).*frame ms: .*p99 \([0-9]*\).*/\1 \2/p' <<<"$said" | awk '{ print int($1 / 1000 + $2) }')
    ((inputs > 20)) || { echo "failed: $name: only $inputs movements were timed"; exit 1; }
}
delay free
# By design a picture is at least 6 ms old. A busy machine delays ticks and pictures, and with them the movement.
((median >= 6 && median < 100 + 10 * slow)) || { echo "failed: the delay cannot be $median ms, with $slow ms for ticks and pictures"; exit 1; }
delay stalled render 300 250
((p99 >= 200)) || { echo "failed: a stall of 250 ms does not show"; exit 1; }

XDG_CONFIG_HOME=$folder/config "$thaum" doctor --json "$folder/doctor.json" | grep 'input delay'
grep -q '"input_to_picture_ms_p99": [0-9]' "$folder/doctor.json" || { echo "failed: doctor --json lacks it"; exit 1; }
echo "the delay is measured"
