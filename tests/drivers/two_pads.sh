#!/usr/bin/env bash
# tests/drivers/two_pads.sh THAUM PAD_HARNESS LOG_PROBE PRESS_KEYS: two players with a pad each, under Xvfb
# with pads by umockdev. A name is typed in the settings and stays in their file. Both pads are pulled out and
# put back in the other order: each one still moves its own player. The cross (direction pad) acts as the
# mouse's wheel, and the pause begins the match again. Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 harness=$2 probe=$3 press_keys=$4
need Xvfb xdotool umockdev-wrapper
open_screen 1280x720
few_pictures
settings=$XDG_CONFIG_HOME/thaum/settings.toml
matches=$XDG_DATA_HOME/thaum/matches
at_failure() { picture failed; }

pad() { echo "$@" >&4; }
logs() { find "$matches" -name '*.thaumlog' 2>/dev/null | sort; }
has_logs() { [ "$(logs | wc -l)" = "$1" ]; }
look() { seen=$("$probe" "$(logs | tail -1)" --input 2>/dev/null) || true; }
field() { sed -n "s/^device $1:.* $2 \\(.*\\)/\\1/p" <<<"$seen" | cut -d' ' -f1; }
logged() { look; [ "$(field "$1" "$2")" = "$3" ]; }

mkfifo "$folder/pad"
umockdev-wrapper "$harness" --two "$thaum" --vs --hands pad,pad 4>&- <"$folder/pad" >"$folder/said" 2>&1 &
game=$!
exec 4>"$folder/pad"
eventually "no match" has_logs 1

# 1. A name for player 1. The letters w and q are part of the name, and neither move nor leave.
presses Escape
eventually "no pause" pause_menu
choose Settings s
moves_on Return
choose "Each player's own settings" Up
moves_on Return
choose Name
moves_on Return
presses w Q q Return
eventually "the name is not in the settings" grep -q '^name = "wQq"$' "$settings"
picture name
presses Escape Escape Escape
eventually "Esc did not go on" no_pause_menu

# 2. Both pads leave. The second one comes back first, and each belongs to its player as before.
pad plugged 0
eventually "no pause when the first pad was pulled out" pause_menu
pad 2.plugged 0
sleep 1
picture lost
pad 2.plugged 1
sleep 0.5
pad plugged 1
# moves PAD VALUE DEVICE STRAFE: takes a pad with a press of its button, unless that is done, and pushes its stick. Tests
# whether the player moves. A slow machine may see the pad, or its button, only later.
moves() {
    pad "$1b" 1
    sleep 0.2
    pad "$1b" 0
    pad "$1lx" "$2"
    sleep 0.3
    logged "$3" strafe "$4"
}
eventually "the first pad does not move player 1" moves "" 32767 0 0..127
[ "$(field 1 strafe)" = 0..0 ] || failed "the first pad moves player 2"
pad lx 0
eventually "the second pad does not move player 2" moves 2. -32768 1 -127..0
[ "$(field 0 strafe)" = 0..127 ] || failed "the second pad moves player 1"
pad 2.lx 0
pad hy -1
eventually "the cross does not turn the wheel" eval 'look; [ "$(field 0 wheel)" -gt 3 ]'
pad hy 0

# 3. The pause menu begins the match again, with a recording of its own.
presses Escape
eventually "no pause" pause_menu
choose 'Restart the match' s
presses Return
eventually "no second match" has_logs 2
eventually "the pause is still there" no_pause_menu
presses Escape
eventually "no pause in the second match" pause_menu
picture named
presses q
exec 4>&-
wait "$game" || failed "the program's exit code"
for log in $(logs); do
    seen=$("$probe" "$log")
    grep -q 'replay same' <<<"$seen" || failed "$log does not play again"
done
echo "two pads keep their players, a name is kept, and the match begins again"
