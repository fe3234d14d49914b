#!/usr/bin/env bash
# tests/drivers/pads.sh THAUM PAD_HARNESS LOG_PROBE PRESS_KEYS: pads that no table knows or that may not be
# read, under Xvfb with devices by umockdev. An Xbox pad of a version that no table has plays, and the match
# waits for the other player's missing pad. A joystick that SDL does not know is reported, is set up in the
# menu, plays, and plays again after a restart; it is set up again and forgotten. A pad that may not be read
# is reported by the program and by `thaum doctor`. A signal stops the motors. Exits with 77 if a tool is
# missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 harness=$2 probe=$3 press_keys=$4
need Xvfb xdotool umockdev-wrapper setpriv
open_screen 1280x720
few_pictures
matches=$XDG_DATA_HOME/thaum/matches
own=$XDG_CONFIG_HOME/thaum/pads.txt
at_failure() { cat "$folder/said"; picture failed; }

pad() { echo "$@" >&4; }
says() { grep -qE "$1" "$folder/said"; }
log() { find "$matches" -name '*.thaumlog' 2>/dev/null | sort | tail -1; }
field() { sed -n "s/^device $1:.* $2 \\(.*\\)/\\1/p" <<<"$seen" | cut -d' ' -f1; }
logged() {
    seen=$("$probe" "$(log)" --input 2>/dev/null) || true
    [ "$(field "$1" "$2")" = "$3" ]
}
# starts OPTIONS -- ARGUMENTS: starts the program with a pad. ends: ends it.
starts() {
    local options=()
    while [ "$1" != -- ]; do
        options+=("$1")
        shift
    done
    shift
    rm -f "$folder/pad"
    mkfifo "$folder/pad"
    umockdev-wrapper "$harness" "${options[@]}" "$thaum" "$@" 4>&- <"$folder/pad" >"$folder/said" 2>&1 &
    game=$!
    exec 4>"$folder/pad"
}
ends() {
    pad signal 15
    exec 4>&-
    wait "$game" || failed "the program's exit code"
}

# 1. One pad for two players, of another version than any that is known. The match begins paused, and goes on with the
# keypad. The pad plays, and its motors stop at a signal.
starts --version 0599 --felt "$folder/felt" -- --vs --hands pad,pad
eventually "the match does not wait for the missing pad" pause_menu
picture missing
presses Escape
eventually "no word on what Esc waits for" paused
sleep 0.5
picture refused
paused || failed "the match goes on without the second pad"
presses KP_0
eventually "the keypad does not take the second seat" no_pause_menu
pad lx 32767
pad rt 255
eventually "the pad's trigger" logged 0 trigger 255
eventually "the pad's stick" logged 0 strafe 0..127
eventually "the wand is not felt" [ -s "$folder/felt" ]
ends
grep -q '^remove' "$folder/felt" || failed "the motors were not let go of"
awk '/^play . 1$/ { on[$2] = 1 } /^play . 0$/ { on[$2] = 0 } /^remove/ { on[$2] = 0 } END { exit on[0] || on[1] }' "$folder/felt" ||
    failed "a motor runs on after a signal"

# 2. A joystick that SDL does not know.
starts --stick --
eventually "no start screen" menu_open
eventually "no word on the joystick" says "^joystick 'Stick of wood and string' is not known: "
picture unknown
choose Controls Up
moves_on Return
choose 'Set up Stick of wood and string' Up
presses Return
eventually "no question" says '^set up: 1 of 20: press A'
picture set_up
# answers NUMBER WHAT VALUE REST: moves the part WHAT from REST to VALUE, which answers a question, and tests
# whether the next one is asked. A slow machine may not see that the part before was released; then it asks
# for another press, so answer repeats this.
answers() {
    pad "$2" "$4"
    sleep 0.2
    pad "$2" "$3"
    sleep 0.2
    says "^set up: $(($1 + 1)) of 20: "
}
answer() {
    eventually "question $1 was not answered" answers "$@"
    pad "$2" "$4"
}
answer 1 button.3 1 0
answer 2 button.2 1 0
answer 3 button.1 1 0
answer 4 button.0 1 0
answer 5 axis.0 32767 0
answer 6 axis.1 32767 0
answer 7 axis.3 32767 0
answer 8 axis.2 32767 0
answer 9 axis.5 32767 -32768
left_out() {
    for question in "$@"; do
        presses Return
        eventually "question $question was not left out" says "^set up: $((question + 1)) of 20: "
    done
}
left_out 10 11 12
presses Return
sleep 0.3
picture needed
! says '^set up: 14 of 20' || failed "Start was left out"
answer 13 button.5 1 0
left_out 14 15 16 17 18 19
presses Return
eventually "the mapping was not kept" grep -qs '^0300.*,Stick of wood and string,a:b3,b:b2,x:b1,y:b0,leftx:a0,lefty:a1,rightx:a3,righty:a2,righttrigger:a5,start:b5,platform:Linux,$' "$own"
picture kept
# The joystick plays: its button B leaves the page, and its X joins and starts a match, whatever row is
# chosen.
pad button.2 1
sleep 0.3
pad button.2 0
joins() {
    pad button.1 1
    sleep 0.3
    pad button.1 0
    sleep 0.3
    [ -n "$(log)" ] && [ "$(log)" != "$first" ]
}
first=$(log)
eventually "no match by the joystick's X" joins
pad axis.5 32767
eventually "the joystick's trigger" logged 0 trigger 255
ends

# 3. After a restart the joystick plays at once, with the same mapping.
starts --stick -- --solo 1 --hands pad --record "$folder/again"
log() { echo "$folder/again"; }
pad axis.0 32767
eventually "the joystick's stick after a restart" logged 0 strafe 0..127
! says 'is not known' || failed "the joystick is still told"
ends

# 4. The joystick is set up again: its old B answers a question and does not leave the page. Esc keeps the old
# answers. Then its set-up is forgotten, and the joystick is unknown at once. Lines of the file that cannot be
# read are reported with their place.
printf '\xef\xbb\xbfrubbish\r\n03000000aabb00001122000001000000,Nothing,platform:Linux,\r\n' | cat - "$own" >"$folder/more"
mv "$folder/more" "$own"
starts --stick --
eventually "no start screen" menu_open
choose Controls Up
moves_on Return
choose 'Set up Stick of wood and string again' Up
presses Return
eventually "no question again" says '^set up: 1 of 20: press A'
says "pads.txt:1: 'rubbish' is no mapping of a pad: " || failed "no word on a line of rubbish"
says "pads.txt:2: maps no control of a pad" || failed "no word on a line that maps nothing"
answer 1 button.2 1 0
answer 2 button.3 1 0
picture set_up_again
moves_on Escape
grep -q 'string,a:b3,b:b2,' "$own" || failed "Esc did not keep the old answers"
choose 'Forget the set-up of Stick of wood and string'
presses Return
eventually "it is still known" says "^joystick 'Stick of wood and string' is not known: "
picture forgotten
! grep -q string "$own" || failed "its mapping is still in the file"
ends

# 5. A pad that this user may not read.
locked() { umockdev-wrapper "$harness" --locked setpriv --bounding-set=-dac_override,-dac_read_search "$thaum" "$@"; }
locked --seconds 2 </dev/null >"$folder/said" 2>&1 || true
says "^pad 'Microsoft X-Box 360 pad' may not be read \\(/dev/input/event0\\): 'thaum doctor' " || failed "no word on the locked pad"
! locked doctor --json "$folder/found" </dev/null >"$folder/said" 2>&1 || failed "the doctor finds nothing missing"
grep -A4 -B4 '"pad"' "$folder/found" | grep -q '/dev/input/event0) may not be read' || failed "the doctor does not tell of the locked pad"
grep -q 'uaccess' "$folder/found" || failed "the doctor does not say how to unlock it"
echo "a pad of a new version, an unknown joystick and a locked pad are played or told"
