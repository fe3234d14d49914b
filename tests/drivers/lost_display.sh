#!/usr/bin/env bash
# tests/drivers/lost_display.sh THAUM: when the X server ends, as at a logout, the program says so in one line and ends
# with code 1, while it starts as well as during a match with sound.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
need Xvfb xdotool
thaum=$(readlink -f "$1")
open_screen 640x360
few_pictures

match_is_shown() { window_is_there && ls "$XDG_DATA_HOME"/thaum/matches/* >/dev/null 2>&1; }
window_is_there() { [ "$(title)" = Thaum ]; }

for moment in window_is_there match_is_shown match_is_shown; do
    "$thaum" --demo >/dev/null 2>"$folder/said" &
    program=$!
    eventually "no window" "$moment"
    kill -9 "$screen_server"
    status=0
    wait "$program" || status=$?
    [[ $status == 1 && $(cat "$folder/said") == "the display is gone: the X server has ended" ]] ||
        failed "$moment: exit $status, said: $(cat "$folder/said")"
    rm -rf "$folder"
    open_screen 640x360
    few_pictures
done
echo "three ends of one line"
