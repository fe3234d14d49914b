#!/usr/bin/env bash
# tests/drivers/duel_to_death.sh THAUM PAD_HARNESS LOG_PROBE PRESS_KEYS: two players in the program under Xvfb.
# Player 2 turns with the pad's stick and kills player 1. Player 1 returns on another pad, turns with the mouse and kills
# with it. The log must say 1 : 1 and replay to the same bits. The test reads positions from the log while it is being
# written, so a busy machine makes the duel longer but does not change it. Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 harness=$2 probe=$3 press_keys=$4
need Xvfb xdotool umockdev-wrapper
open_screen 640x360
few_pictures
# A slow turning speed, so that one push of the stick turns by a small angle.
echo 'turn_deg_per_s = 22.5' >>"$XDG_CONFIG_HOME/thaum/settings.toml"

mkfifo "$folder/pad"
umockdev-wrapper "$harness" "$thaum" --vs --record "$folder/log" \
    --set bolt.shot.damage=40 --set bolt.shot.spread_deg=0.2 4>&- <"$folder/pad" &
game=$!
exec 4>"$folder/pad"
pad() { echo "$@" >&4; }

coproc follower { exec "$probe" "$folder/log" --follow "$folder/state.csv" 4>&-; }
# look: writes the newest states in the log to a file and sets `result`; fails while there is no log.
look() {
    echo >&"${follower[1]}"
    read -r result <&"${follower[0]}"
    [ -n "$result" ]
}
# of_state AWK: evaluates an expression over the newest row s[column name] and the row b[column name] of 256
# ticks before.
of_state() {
    awk -F, -v degrees=57.29577951308232 "
        NR == 1 { for (i = 1; i <= NF; i++) name[i] = \$i; next }
        { rows++; for (i = 1; i <= NF; i++) all[rows, name[i]] = \$i }
        END { for (i in name) { s[name[i]] = all[rows, name[i]]; b[name[i]] = all[(rows > 8 ? rows - 8 : 1), name[i]] }
              $1 }" "$folder/state.csv"
}
ticks() { of_state 'print s["tick"] + 0'; }
is_written() { look && [ "$(ticks)" -gt "$1" ]; }
scored() { look && [[ $result == *"score $1"* ]]; }
alive() { look && of_state 'exit s["p1_dead"] != 0'; }
# stands_still ONE TICK: tests whether player ONE has not turned lately; the log must go beyond the tick.
stands_still() { is_written "$2" && of_state "exit s[\"$1_yaw_rad\"] != b[\"$1_yaw_rad\"]"; }
# error ONE OTHER: angle by which player ONE must turn to face OTHER (degrees, positive to the left).
error() {
    of_state "turn = atan2(s[\"$1_x_m\"] - s[\"$2_x_m\"], s[\"$1_z_m\"] - s[\"$2_z_m\"]) * degrees - s[\"$1_yaw_rad\"] * degrees
              while (turn > 180) turn -= 360
              while (turn < -180) turn += 360
              print turn"
}
# stick ANGLE: turns player 2. Large angle: the whole stick, 22.5 degrees/s. Small angle: 0.207 of it, which is 1.5
# degrees/s beyond the dead zone of 0.15.
stick() {
    local push seconds
    read -r push seconds < <(awk -v a="$1" 'BEGIN {
        size = a < 0 ? -a : a; far = size > 8; push = far ? 32767 : 6773
        print (a < 0 ? push : -push), size / (far ? 22.5 : 1.5) }')
    pad rx "$push"
    sleep "$seconds"
    pad rx 0
}
# mouse ANGLE: turns player 1. The mouse's 1149 counts are one radian.
mouse() { xdotool mousemove_relative -- "$(awk -v a="$1" 'BEGIN { printf "%d", -a * 1149 / 57.2957795 }')" 0; }
# aims ONE OTHER HOW: turns player ONE by the function HOW until OTHER is in front.
aims() {
    local try away stopped
    for try in {1..40}; do
        stopped=$(ticks)
        eventually "$1 does not stand still" stands_still "$1" $((stopped + 1024))
        away=$(error "$1" "$2")
        echo "$1 looks $away degrees past $2"
        if awk -v a="$away" 'BEGIN { exit !(a < 0.4 && a > -0.4) }'; then return; fi
        "$3" "$away"
        look
    done
    failed "$1 cannot aim"
}

# hits DOWN UP SCORE: fires a short burst by the commands DOWN and UP, waits until the log must show its
# effect, and tests whether the score is SCORE. If fire were held until the score is seen, it would kill again
# on a slow machine.
hits() {
    eval "$1"
    sleep 0.4
    eval "$2"
    look
    local let_go
    let_go=$(ticks)
    eventually "the match stands still" is_written $((let_go + 1024))
    scored "$3"
}

# At the start the players are 30 m apart and do not face each other. The log grows in blocks of 512 ticks.
eventually "no match" is_written 0
aims p2 p1 stick
eventually "player 2 does not hit" hits 'pad rt 255' 'pad rt 0' '0 : 1'
picture player_1_is_dead
eventually "player 1 does not come back" alive
aims p1 p2 mouse
eventually "player 1 does not hit" hits 'xdotool mousedown 1' 'xdotool mouseup 1' '1 : 1'
picture player_2_is_dead
presses Escape
eventually "no pause" paused
presses q
exec 4>&-
wait "$game" || failed "the program's exit code"

result=$("$thaum" replay "$folder/log" --verify)
echo "$result"
grep -q 'score 1 : 1' <<<"$result" || failed "not one kill each"
