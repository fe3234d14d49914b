#!/usr/bin/env bash
# tests/drivers/fake_phantom_plays.sh THAUM FAKE_HD FAKE_HD_OLD LOG_PROBE: matches under Xvfb with an arm
# whose libHD.so is our fake. The match must be recorded and replay with the same forces, the hand must feel its own shots,
# the match must survive a fault of the arm, and without an arm one line must say why.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
. "$(dirname "$0")/shots.sh"
thaum=$1 fake=$2 old=$3 probe=$4
need Xvfb
open_screen 640x360
few_pictures

# Path of the hand: still at first, then to and fro with the button held, so that each shot kicks.
awk 'BEGIN {
    print 0, 0, 0, 0, 0; print 300, 0, 0, 0, 1
    for (ms = 320; ms <= 60000; ms += 20) print ms, 20 * sin((ms - 300) / 400), 5 * sin((ms - 300) / 150), 0, 1 }' >"$folder/way"

# A match of an arm against a bot, whose shots are too weak to kill. The wand never runs dry.
match=("$thaum" --solo 1 --hands arm --seed 1 --set haptics.share=1 --set bolt.shot.damage=1 --set bolt.energy.cost=0.01)
# play NAME SECONDS FAKE_HD: plays a match of that length, with a log and the program's output. The arm's clock keeps
# running when a busy machine slows the match, so faults of the arm are timed from the first force it felt.
play() {
    THAUM_LIBHD=$fake FAKE_HD=$3 "${match[@]}" --seconds "$2" --record "$folder/$1.thaumlog" 2>"$folder/$1.txt" || { cat "$folder/$1.txt"; failed "$1 does not play"; }
    told_and_replayed "$1"
}
# told_and_replayed NAME: the program must have said how well the arm kept time, and the log must replay with the
# forces that the arm felt.
told_and_replayed() {
    cat "$folder/$1.txt"
    grep -q '^arm: [0-9]* ticks' "$folder/$1.txt" || failed "$1: how well time was kept is not said"
    grep -q '; 0 forces differ' "$folder/$1.txt" || failed "$1: the match computes other forces than the arm's thread"
    "$thaum" replay "$folder/$1.thaumlog" --verify --forces "$folder/$1.csv" | tee "$folder/$1.verified"
    grep -q 'state hashes agree' "$folder/$1.verified" || failed "$1: the replay differs"
}

# feels NAME, rests NAME: tests whether the arm that writes $folder/NAME.live exerts a force now, or none.
feels() { awk -v f="$(live "$1" 2 f8)" 'BEGIN { exit !(f > 0.3) }'; }
rests() { ! feels "$1"; }
# feels_three NAME: waits until the arm has given a force, and none again, three times. A busy machine may keep forces
# from an arm for long.
feels_three() {
    for _ in 1 2 3; do
        eventually "$1 feels nothing" feels "$1"
        eventually "a force stays on $1" rests "$1"
    done
}

# The shots must be felt: kicks of 1.2 N towards the user. The hand must have moved to both sides.
THAUM_LIBHD=$fake FAKE_HD="path=$folder/way,live=$folder/good.live" "${match[@]}" --record "$folder/good.thaumlog" 2>"$folder/good.txt" &
game=$!
shots_are_felt() {
    "$thaum" replay "$folder/good.thaumlog" --forces "$folder/good.csv" >/dev/null 2>&1 || true
    [ -s "$folder/good.csv" ] || return 1
    awk -F, 'NR > 1 { if ($8 > peak) peak = $8
                      if ($8 <= 0 && peak > 0) { if (peak > 1.1 && peak < 1.3) shots++; else others++; peak = 0 }
                      if ($3 > right) right = $3; if ($3 < left) left = $3 }
        END { print shots + 0, "kicks of 1.1 to 1.3 N,", others + 0, "others, hand", left, "to", right, "m"
              exit !(shots >= 3 && right > 0.01 && left < -0.01) }' "$folder/good.csv" >"$folder/good.shots"
}
eventually "the forces are not those of shots" shots_are_felt
cat "$folder/good.shots"
kill -TERM $game
wait $game || { cat "$folder/good.txt"; failed "good does not end"; }
told_and_replayed good

# After a fault of the arm the match goes on without its forces.
play vanished 8 "path=$folder/way,felt,vanish=3000,back=1000000"
grep -q 'plug it in' "$folder/vanished.txt" || failed "nobody says that the arm is lost"
awk -F, 'NR > 1 { if ($8 > 1) felt++ } END { print "felt in", felt + 0, "ticks; at the end:", $6, $7, $8, $9
    exit !(felt > 0 && $2 > 2 && $6 == 0 && $7 == 0 && $8 == 0) }' "$folder/vanished.csv" || failed "forces of an arm that is not there"
play stopped 4 "path=$folder/way,felt,stop=500,back=1000000"
play late 3 "path=$folder/way,late=50,burst"
play numberless 3 "path=$folder/way,nan=1000"

# An arm that comes back while the hand is still at first: shots are felt, then none, then shots again. The match ends
# once the arm has felt a force three times after its return.
awk 'BEGIN {
    print 0, 0, 0, 0, 0; print 1000, 0, 0, 0, 1
    for (ms = 1020; ms <= 60000; ms += 20) print ms, 20 * sin((ms - 1000) / 400), 5 * sin((ms - 1000) / 150), 0, 1 }' >"$folder/calm"
THAUM_LIBHD=$fake FAKE_HD="path=$folder/calm,live=$folder/back.live,felt,vanish=2000,back=3" \
    "${match[@]}" --record "$folder/back.thaumlog" 2>"$folder/back.txt" &
game=$!
says_back() { grep -qs 'the arm is back' "$folder/back.txt"; }
eventually "nobody says that it is back" says_back
feels_three back
kill -TERM $game
wait $game || { cat "$folder/back.txt"; failed "back does not end"; }
told_and_replayed back
grep -q 'lost 1 times' "$folder/back.txt" || failed "it was not lost once"
"$thaum" replay "$folder/back.thaumlog" --events "$folder/back.events.csv" >/dev/null || failed "back does not replay"
awk -F, 'FNR == 1 { file++ }
    file == 1 && /,left,/ { left = $1 }
    file == 1 && /,joined,/ { joined = $1 }
    file == 2 && FNR > 1 { force = $6 ^ 2 + $7 ^ 2 + $8 ^ 2
        part = $1 <= left ? "before" : $1 <= joined ? "away" : "after"
        shots[part] += force > 1 && last <= 1
        # 50 ticks are enough for the largest force to fade.
        held += part == "away" && $1 > left + 50 && force > 0
        last = force }
    END { print shots["before"] + 0, "shots, then", joined - left, "ticks without the arm,", held + 0, "of them with a force, then", shots["after"] + 0
          exit !(shots["before"] >= 1 && left < joined && held == 0 && shots["after"] >= 3) }' \
    "$folder/back.events.csv" "$folder/back.csv" || failed "it is not felt again"
play stopped_and_back 6 "path=$folder/calm,felt,stop=1000,back=0"
grep -q 'the arm is back' "$folder/stopped_and_back.txt" || failed "nobody says that it is back"

# Two arms of the library, which has one thread for both, play one match: each player feels shots.
THAUM_LIBHD=$fake FAKE_HD="path=$folder/way,live=$folder/first.live" FAKE_HD_SECOND="path=$folder/calm,live=$folder/second.live" \
    THAUM_HD_ARMS="Default Device,Right" "$thaum" --vs --hands arm,arm --seed 1 --set haptics.share=1 --set bolt.shot.damage=1 \
    --set bolt.energy.cost=0.01 --record "$folder/two.thaumlog" 2>"$folder/two.txt" &
game=$!
feels_three first
feels_three second
kill -TERM $game
wait $game || { cat "$folder/two.txt"; failed "two arms do not play"; }
cat "$folder/two.txt"
[ "$(grep -c '^arm Touch F000000[12]: .*; 0 forces differ' "$folder/two.txt")" -eq 2 ] || failed "two arms: the match computes other forces"
"$thaum" replay "$folder/two.thaumlog" --verify --forces "$folder/two.csv" || failed "two arms: the replay differs"
expect_shots two 1 0
expect_shots two 2 0

# The practice range and the start screen must work with an arm.
THAUM_LIBHD=$fake FAKE_HD="path=$folder/way" "$thaum" range --hands arm --seconds 3 >"$folder/range.txt" 2>&1 || failed "no range by arm"
cat "$folder/range.txt"
grep -Eq 'range: [0-9]+ of [1-9]' "$folder/range.txt" || failed "its button does not shoot on the range"
grep -q '; 0 forces differ' "$folder/range.txt" || failed "the range computes other forces than the arm's thread"
# The start screen shows the arm in its picture only. Here the screen must survive an arm that nobody uses,
# and one that vanishes.
THAUM_LIBHD=$fake FAKE_HD="path=$folder/way,vanish=1000" "$thaum" --hands arm >"$folder/start.txt" 2>&1 &
start=$!
eventually "the start screen does not see that it goes" grep -q 'plug it in' "$folder/start.txt"
kill -TERM $start
wait $start || failed "no start screen with an arm"

# An arm whose clock is faster than the match's. arm_pace_test.cpp tests without a clock that the match keeps
# pace with it.
play faster 5 "path=$folder/way,rate=1008"

# Without a usable arm, one line must say what to do, and no match may start.
refuses() { # LIBRARY FAKE_HD WORDS: expects one line with WORDS, and no match
    local said code=0
    said=$(THAUM_LIBHD=$1 FAKE_HD=$2 "$thaum" --solo 1 --hands arm --seconds 1 --record "$folder/none.thaumlog" 2>&1) || code=$?
    echo "$said"
    [ "$code" -ne 0 ] || failed "plays without an arm"
    [ "$(wc -l <<<"$said")" -eq 1 ] || failed "more than a line"
    grep -q "$3" <<<"$said" || failed "does not say '$3'"
    [ ! -e "$folder/none.thaumlog" ] || failed "leaves a log"
}
refuses "$folder/no/libHD.so" "" "THAUM_LIBHD"
refuses "$old" "" "too old"
refuses "$fake" manual "inkwell"
refuses "$fake" no_permission "may not open its port"

THAUM_LIBHD=$fake FAKE_HD=late=100 "$thaum" doctor --json "$folder/doctor.json" | grep -A1 ' arm ' || failed "doctor knows no arm"
grep -q '"pose_to_force_us_p99"' "$folder/doctor.json" || failed "doctor --json lacks its times"
grep -Eq '"missed": [1-9]' "$folder/doctor.json" || failed "doctor sees no missed tick"
echo "the fake arm plays"
