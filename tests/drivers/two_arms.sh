#!/usr/bin/env bash
# tests/drivers/two_arms.sh THAUM LOG_PROBE: the program with a driver of simulated arms that stands outside the product (fake_arm). Two arms
# play one match under Xvfb: each player feels the shots of their own arm, the log and its forces verify, and one arm may
# vanish and come back while the other plays on. doctor and --feel know both arms.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
. "$(dirname "$0")/shots.sh"
thaum=$1 probe=$2
need Xvfb
open_screen 640x360
few_pictures

# hand FILE FROM_MS: a hand that holds still, then moves to and fro with the button held, so that each shot kicks.
hand() {
    awk -v from="$2" 'BEGIN {
        print 0, 0, 0, 0, 0; print from, 0, 0, 0, 1
        for (ms = from + 20; ms <= 120000; ms += 20) print ms, 20 * sin((ms - from) / 400), 5 * sin((ms - from) / 150), 0, 1 }' >"$1"
}
hand "$folder/first" 300
hand "$folder/second" 600
first="path=$folder/first,live=$folder/first.live" second="path=$folder/second,live=$folder/second.live"

was_felt() { awk -v f="$(live "$1" 3 f8)" 'BEGIN { exit !(f > 0.3) }'; }
both_were_felt() { was_felt first && was_felt second; }
is_let_go() {
    [ "$(live "$1" 0 f8) $(live "$1" 1 f8) $(live "$1" 2 f8)" = "0 0 0" ] || failed "$1: a force stays"
    [ "$(live "$1" 6 f8) $(live "$1" 7 f8) $(live "$1" 8 f8)" = "0 0 0" ] || failed "$1: closed with a force"
    [ "$(live "$1" 5 u8)" = 0 ] || failed "$1: the arm is not let go of"
}

# play NAME SECONDS HANDS SCRIPTS: a match of two arms and its log. Nobody dies of the shots.
play() {
    rm -f "$folder/first.live" "$folder/second.live"
    FAKE_ARMS=$4 "$thaum" --vs --hands "$3" --seed 1 --seconds "$2" --set haptics.share=1 --set bolt.shot.damage=1 \
        --record "$folder/$1.thaumlog" 2>"$folder/$1.txt" || { cat "$folder/$1.txt"; failed "$1 does not play"; }
    cat "$folder/$1.txt"
    [ "$(grep -c '; 0 forces differ' "$folder/$1.txt")" -eq 2 ] || failed "$1: the match computes other forces than an arm's thread"
    "$thaum" replay "$folder/$1.thaumlog" --verify --forces "$folder/$1.csv" | tee "$folder/$1.verified"
    grep -q 'state hashes agree' "$folder/$1.verified" || failed "$1: the replay differs"
    is_let_go first
    is_let_go second
}

# doctor lists both arms by number, and the driver. The arm of a real driver is missing here, which is no fault.
FAKE_ARMS="name=Left;name=Right" THAUM_LIBHD=$folder/none.so "$thaum" doctor --json "$folder/doctor.json" >"$folder/doctor"
grep ' arm ' -A1 "$folder/doctor"
grep -q '^good     arm          arm:0 is Left A0' "$folder/doctor" || failed "doctor does not list the first arm"
grep -q '^good     arm          arm:1 is Right A1' "$folder/doctor" || failed "doctor does not list the second arm"
grep -q 'arm driver .*fake: simulated arms' "$folder/doctor" || failed "doctor does not list the driver"
grep -q 'THAUM_LIBHD' "$folder/doctor" || failed "doctor does not say what the real driver needs"
[ "$(grep -c '"pose_to_force_us_p99"' "$folder/doctor.json")" -eq 2 ] || failed "doctor --json lacks the times of an arm"

# Both players feel their own shots.
play both 5 arm:0,arm:1 "$first;$second"
expect_shots both 1 0
expect_shots both 2 0
both_were_felt || failed "an arm got no force"

# If one player takes an arm by number, the word without a number gives the other player the other arm.
play swapped 2 arm:1,arm "$first;$second"
grep '^arm ' "$folder/swapped.txt" | head -n 1 | grep -q 'Fake A1' || failed "player 1 does not have arm:1"

# One arm vanishes and comes back; the other one plays on.
play vanished 8 arm,arm "$first,felt,vanish=1000,back=2;$second"
grep -q '^Fake A0: .*plug it in' "$folder/vanished.txt" || failed "nobody says which arm is lost"
grep -q '^Fake A0: the arm is back' "$folder/vanished.txt" || failed "nobody says that it is back"
! grep -q '^Fake A1: ' "$folder/vanished.txt" || failed "the other arm is said to be lost"
expect_shots vanished 2 4
"$thaum" replay "$folder/vanished.thaumlog" --events "$folder/vanished.csv" >/dev/null || failed "vanished does not replay"
changes=$(grep -oE ',(left|joined),[^,]*,[^,]*,[^,]*,' "$folder/vanished.csv" | xargs)
[ "$changes" = ",left,1,,Fake A0, ,joined,1,,Fake A0," ] || failed "the log says of lost arms: $changes"

# Another arm that is too weak for the match is passed over.
play weak 2 arm,arm "name=Weak,peak=1;$first;$second"
! grep -q 'Weak' "$folder/weak.txt" || failed "a weak arm plays"

# A signal ends both forces.
rm -f "$folder/first.live" "$folder/second.live"
FAKE_ARMS="$first;$second" "$thaum" --vs --hands arm,arm --seed 1 --record "$folder/ended.thaumlog" >"$folder/ended.txt" 2>&1 &
game=$!
eventually "nothing is felt" both_were_felt
kill -TERM $game
wait $game || failed "a signal is no clean end"
cat "$folder/ended.txt"
is_let_go first
is_let_go second

# The start screen must survive two arms, one of which vanishes for good. (If the arm came back soon, a busy
# machine might not show its absence.)
FAKE_ARMS="$first;$second,vanish=1000,back=1000000" "$thaum" --hands arm,arm >"$folder/start.txt" 2>&1 &
start=$!
eventually "the start screen does not see that one goes" grep -q '^Fake A1: .*plug it in' "$folder/start.txt"
kill -TERM $start
wait $start || failed "no start screen with two arms"

# A log is felt at an arm by number, by name, and by the driver's word.
for name in arm:1 "Fake A1" a1; do
    FAKE_ARMS="$first;$second" "$thaum" replay "$folder/swapped.thaumlog" --feel "$name" --player 2 >"$folder/felt" || failed "not felt at $name"
    grep "player 2's forces on Fake A1" "$folder/felt" || failed "not felt at $name"
done
FAKE_ARMS="$first;$second" "$thaum" replay "$folder/swapped.thaumlog" --feel fake >"$folder/felt" || failed "not felt at fake"
grep "player 1's forces on Fake A0" "$folder/felt" || failed "not felt at the first arm"

refuses() { # WORDS SCRIPTS ARGUMENT...: expects one line with WORDS and exit code 2
    local words=$1 scripts=$2 said code=0
    shift 2
    said=$(FAKE_ARMS=$scripts THAUM_LIBHD=$folder/none.so "$thaum" "$@" 2>&1) || code=$?
    echo "$said"
    [ "$code" -eq 2 ] || failed "exit $code"
    [ "$(wc -l <<<"$said")" -eq 1 ] || failed "more than a line"
    grep -q -e "$words" <<<"$said" || failed "does not say '$words'"
}
none=$folder/none.thaumlog
refuses "there are 3 arms, numbered from 0" "$first;$second" --vs --hands arm:7 --record "$none"
refuses "takes one or two" "$first;$second" --vs --hands arm:0,arm:0 --record "$none"
refuses "THAUM_LIBHD" "$first" --vs --hands arm,arm --record "$none"
refuses "must be a number" "$first" --vs --hands arm:x --record "$none"
refuses "found Fake A0 (or: arm:0, fake), Fake A1" "$first;$second" replay "$folder/swapped.thaumlog" --feel falcon
[ ! -e "$none" ] || failed "leaves a log"
echo "two arms play one match"
