#!/usr/bin/env bash
# tests/drivers/verify.sh THAUM FORGE_LOG: a changed log with recomputed checksums must not be verified, nor a
# log whose hashes prove nothing.
set -uo pipefail
thaum=$(readlink -f "$1")
forge=$(readlink -f "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
unset DISPLAY WAYLAND_DISPLAY
failures=0
fail() { echo "failed: $1"; failures=$((failures + 1)); }

"$thaum" --headless --seconds 3.3 --out made >/dev/null || { echo "failed: no recording"; exit 1; }
log=made/duel.thaumlog

# differs WORDS HOW: expects that the forged log is reported with these words.
differs() {
    local said status
    "$forge" "$2" "$log" "$2.thaumlog" || fail "forging $2"
    said=$("$thaum" replay "$2.thaumlog" --verify --events "$2.csv" 2>&1)
    status=$?
    [[ $status == 1 && $said == *"$1"* && $(grep -c . <<<"$said") == 1 ]] || fail "$2: exit $status, said: $said"
    [[ $said != *[$'\x01'-$'\x1f']* ]] || fail "$2: control characters reach the terminal"
    [[ ! -e $2.csv ]] || fail "$2: leaves a table of what did not happen"
}
differs "tick 128: the log has no hash of this state" no_hashes
differs "tick 256: the log has no hash of this state" no_middle
differs "tick 3300: the log has no hash of its last state" no_last
differs "tick 256: state differs" early_input
differs "tick 3300: state differs" late_input
differs 'the result differs: the log has "player 2 wins by kills' result
differs "the result differs" codes

"$forge" same "$log" same.thaumlog || fail "forging nothing"
said=$("$thaum" replay same.thaumlog --verify) || fail "an honest copy: $said"
[[ $said == *"26 state hashes agree, the last at tick 3300"* ]] || fail "hashes of an honest copy: $said"

# Pictures of moments after the last equal hash, at tick 128, must be deleted.
said=$("$thaum" replay early_input.thaumlog --shots pictures --shot-every 0.05 --size 64x64 2>&1)
status=$?
if [[ $said != *OpenGL* ]]; then  # no pictures without OpenGL
    [[ $status == 1 && $said == *"tick 256: state differs"* ]] || fail "pictures of a forged log: exit $status, said: $said"
    [[ $(echo pictures/*) == "pictures/shot_00000000.png pictures/shot_00000050.png pictures/shot_00000100.png" ]] ||
        fail "pictures of what never happened: $(echo pictures/*)"
fi

# A table must hold the result of the replay, and no control characters from the log.
"$thaum" replay codes.thaumlog --events codes.csv >/dev/null 2>&1
! grep -q $'[\x01-\x09\x0b-\x1f]' codes.csv || fail "the table has control characters"
"$thaum" replay result.thaumlog --events result.csv >/dev/null 2>&1
! grep -q 'player 2 wins' result.csv || fail "the table repeats a false result"

# A log cut off by a crash must replay up to its last complete block and say so.
size=$(od -An -tu4 -j12 -N4 "$log")
first=$((24 + size))
second=$((first + 40 + $(od -An -tu4 -j$((first + 12)) -N4 "$log")))
head -c $((second + 50)) "$log" >cut.thaumlog
said=$("$thaum" replay cut.thaumlog --verify 2>line) || fail "a cut-off log: $said"
[[ $said == "512 ticks, 4 state hashes agree, the last at tick 512"* && $(cat line) == *"cut off after tick 512"* ]] ||
    fail "a cut-off log: $said, $(cat line)"
# A log that lacks a part of its end block alone, as on a full disk, has all ticks, but no hash of the last one.
head -c -1 "$log" >endless.thaumlog
said=$("$thaum" replay endless.thaumlog --verify 2>line) || fail "a log without its end: $said"
[[ $said == "3300 ticks, 25 state hashes agree, the last at tick 3200"* && $(cat line) == *"cut off after tick 3300"* ]] ||
    fail "a log without its end: $said, $(cat line)"
head -c "$first" "$log" >header.thaumlog
said=$("$thaum" replay header.thaumlog --verify 2>/dev/null)
[[ $? == 1 && $said == *"nothing was compared"* ]] || fail "a header alone: $said"

((failures == 0)) && echo "verified means verified"
exit $((failures > 0))
