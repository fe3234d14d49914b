#!/usr/bin/env bash
# tests/drivers/rumble.sh RUMBLE_PROBE PAD_HARNESS: the motors of two pads by umockdev. Frames for one side run one motor,
# which stops after the time to live. The pad is pulled out and put back. The second pad has no motors. Exits with 77 if a
# tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
probe=$1 harness=$2
need umockdev-wrapper
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0:verify_asan_link_order=0
at_failure() { cat "$folder/said" "$folder/felt"; }

mkfifo "$folder/pad" "$folder/orders"
umockdev-wrapper "$harness" --two --felt "$folder/felt" "$probe" "$folder/orders" 4>&- 5>&- <"$folder/pad" >"$folder/said" 2>&1 &
program=$!
exec 4>"$folder/pad" 5>"$folder/orders"
pad() { echo "$@" >&4; }
feel() { echo "$@" >&5; }
says() { grep -q "^$1\$" "$folder/said"; }
says_last() { [ "$(grep '^player 1 feels' "$folder/said" | tail -1)" = "player 1 $1" ]; }
# since LINE: the lines that the pad's file got after that one. Of those since line $from, felt PATTERN tests
# whether one matches, and stopped whether the last one stops an effect.
lines() { wc -l <"$folder/felt"; }
since() { tail -n +$(($1 + 1)) "$folder/felt"; }
felt() { since "$from" | grep -qE "^$1\$"; }
stopped() { [[ "$(since "$from" | tail -1)" =~ ^play\ [01]\ 0$ ]]; }

# 1. The left side alone, at 70 % of the whole strength: the strong motor, and none after the time to live. Equal frames
# extend the effect: it begins again without a stop. A new effect is uploaded only for motors that have stopped.
eventually "player 1 does not feel" says_last feels
from=0
count() { since "$from" | grep -cE "^$1\$" || true; }
extended() { since "$from" | uniq -d | grep -q '^play [01] 1$'; }
feel 1 1 0 1000000
eventually "no strong motor" felt 'upload [01] 45746 0 48'
eventually "the effect was not extended" extended
feel 1 1 0 0
eventually "the motor did not stop" stopped
! felt 'upload [01] [0-9]+ [1-9][0-9]* 48' || failed "the weak motor ran, too"
[ "$(count 'upload .*')" -le "$(count 'play [01] 0')" ] || failed "equal frames were uploaded again and again"

# Other frames: a second effect begins, and the first one stops right after that.
swapped() {
    feel 1 1 0 100
    sleep 0.1
    feel 1 0.5 0 100
    since "$from" | awk '/^play . 1$/ { began = $2; next } /^play . 0$/ && began != "" && $2 != began { found = 1 } { began = "" } END { exit !found }'
}
eventually "the effects did not take turns" swapped
feel 1 0 0 1
eventually "the motor did not stop after the turns" stopped
awk '/^play . 1$/ { if (on[1 - $2]) late = NR + 1; on[$2] = 1 } /^play . 0$/ { on[$2] = 0 } NR == late { if (on[0] && on[1]) exit 1 }' \
    "$folder/felt" || failed "two effects ran together"

# 2. The right side, and both with a hostile value.
from=$(lines)
feel 1 0 0.5 20
eventually "no weak motor" felt 'upload [01] 0 22873 48'
eventually "the weak motor did not stop" stopped
! felt 'upload [01] [1-9][0-9]* [0-9]+ 48' || failed "the strong motor ran, too"
from=$(lines)
feel 1 0.2 1e30 20
eventually "not both motors" felt 'upload [01] 9252 65535 48'
eventually "both motors did not stop" stopped
! grep '^upload' "$folder/felt" | grep -qv ' 48$' || failed "an effect outlives its frame"

# 3. The pad is pulled out in the middle of an effect, and put back.
feel 1 1 1 1000000
from=$(lines)
eventually "no motors before the pad was pulled out" felt 'play [01] 1'
pad plugged 0
eventually "player 1 still feels" says_last "feels nothing"
from=$(lines)
sleep 0.2
[ "$(lines)" = "$from" ] || failed "a pulled pad was called"
pad plugged 1
eventually "player 1 does not feel again" says_last feels
eventually "no motors after the pad was put back" felt 'upload [01] 45746 45746 48'
feel 1 0 0 1
eventually "the motors did not stop after that" stopped

# 4. A pad without motors is reported in one line.
eventually "no word on the second pad" says "player 2: pad '.*': no rumble: .*"
[ "$(grep -c 'no rumble' "$folder/said")" = 1 ] || failed "several lines on the second pad"
! grep -q '^2\.' "$folder/felt" || failed "the second pad was called"

# 5. At its end the program removes its effects from the pad.
exec 5>&-
eventually "no counts" says 'sent .*'
eventually "effect 0 was left" felt 'remove 0'
pad signal 0
exec 4>&-
wait "$program" || failed "the program's exit code"
echo "each side has its motor, and none stays on: $(grep '^sent' "$folder/said")"
