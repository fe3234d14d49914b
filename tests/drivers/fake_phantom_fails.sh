#!/usr/bin/env bash
# tests/drivers/fake_phantom_fails.sh THAUM FAKE_HD: matches with an arm whose libHD.so is our fake: one ended
# by signals, others whose library hangs, never calls, calls after its end, or returns control characters. The
# arm must be released without force, the log must be complete, and the program must name the fault in one
# line. (tests/unit/arm_modes_test.cpp tests all faults without a match.)
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 fake=$2
need Xvfb
open_screen 640x360
few_pictures
awk 'BEGIN { print 0, 0, 0, 0, 0; print 300, 0, 0, 0, 1
    for (ms = 320; ms <= 600000; ms += 20) print ms, 20 * sin((ms - 300) / 400), 5 * sin((ms - 300) / 150), 0, 1 }' >"$folder/way"

# begin NAME FAKE_HD ARGUMENT...: starts the program in the background; its process is $game.
begin() {
    name=$1
    THAUM_LIBHD=$fake FAKE_HD="path=$folder/way,live=$folder/$name.live,$2" "$thaum" --solo 1 --hands arm --seed 1 \
        --record "$folder/$name.thaumlog" "${@:3}" >"$folder/$name.said" 2>&1 &
    game=$!
}
was_felt() { awk -v f="$(live "$name" 3 f8)" 'BEGIN { exit !(f > 0.3) }'; }
without_force() { [ ! -e "$folder/$name.live" ] || [ "$(live "$name" 0 f8) $(live "$name" 1 f8) $(live "$name" 2 f8)" = "0 0 0" ] || failed "$name: a force stays: $(live "$name" 2 f8) N"; }
let_go() { [ "$(live "$name" 5 u8)" = 0 ] || failed "$name: the arm is not let go of"; }
says() { grep -q "$1" "$folder/$name.said"; }
# ends CODE: waits for the program and checks its exit code.
ends() {
    local code=0
    wait $game || code=$?
    cat "$folder/$name.said"
    [ $code -eq "$1" ] || failed "$name: exit $code instead of $1"
    without_force
}
log_is_whole() {
    "$thaum" replay "$folder/$name.thaumlog" --verify >"$folder/verified" 2>&1 || failed "$name: the replay differs"
    cat "$folder/verified"
    ! grep -q 'cut off' "$folder/verified" || failed "$name: the log was not closed"
}

is_written() { "$thaum" replay "$folder/$name.thaumlog" --verify 2>/dev/null | grep -q '[1-9][0-9]* state hashes agree'; }

for signal in TERM INT HUP; do
    begin "signal_$signal" ""
    eventually "$signal: nothing is felt" was_felt
    eventually "$signal: nothing is recorded" is_written
    kill -$signal $game
    ends 0
    let_go
    says 'ended by a signal' || failed "$signal: it does not say why it ends"
    log_is_whole
done
begin fault ""
eventually "nothing is felt" was_felt
kill -SEGV $game
ends 139

begin silent callback=never
eventually "nobody says that no ticks come" says 'ticks do not come'
eventually "nothing is recorded" is_written
kill -TERM $game
ends 0
let_go
[ "$(grep -c 'ticks do not come' "$folder/silent.said")" -eq 1 ] || failed "it is said more than once"
! says 'the arm is back' || failed "an arm without a tick is said to be back"
log_is_whole

begin hangs_at_the_end hdStopScheduler=blocks --seconds 1
ends 0
log_is_whole
begin calls_after_the_end callback=after_end --seconds 1
ends 0
let_go
begin hangs_at_the_start hdInitDevice=blocks
ends 2
[ "$(wc -l <"$folder/hangs_at_the_start.said")" -eq 1 ] || failed "more than a line"
says 'hangs: hdInitDevice has not returned' || failed "it does not say what hangs"
begin speaks_to_the_terminal strings=control,error_strings=control,felt,warm=100,back=1000000 --seconds 2
ends 0
says 'too warm' || failed "the fault is not said"
! LC_ALL=C grep -q '[^[:print:]]' "$folder/speaks_to_the_terminal.said" || failed "the library's words reach the terminal"

code=0
THAUM_LIBHD=$fake FAKE_HD=callback=never "$thaum" doctor >"$folder/doctor" || code=$?
grep ' arm ' -A1 "$folder/doctor"
[ $code -eq 1 ] || failed "doctor finds nothing wrong with an arm without ticks"
grep -q '^MISSING  arm' "$folder/doctor" || failed "doctor calls an arm without ticks good"
echo "the arm is left without force"
