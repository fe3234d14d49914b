#!/usr/bin/env bash
# tests/drivers/sound.sh THAUM: a match in a window is heard on a sound device that writes a file, and is silent with one
# line where there is no device. Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1
need Xvfb
open_screen 640x360
few_pictures

# OpenAL's own device, which writes what it plays.
printf '[general]\ndrivers = wave\n[wave]\nfile = %s\n' "$folder/heard.wav" >"$folder/alsoft.conf"
ALSOFT_DRIVERS=wave ALSOFT_CONF=$folder/alsoft.conf "$thaum" --demo --seconds 8 >"$folder/out" 2>"$folder/said" ||
    failed "the match with sound ended with an error"
[ ! -s "$folder/said" ] || { cat "$folder/said"; failed "a working device is no news"; }
[ -s "$folder/heard.wav" ] || failed "nothing was played"
# Music and steps leave few bytes at zero; in silence nearly all bytes are zero.
sounding=$(tr -d '\0' <"$folder/heard.wav" | wc -c)
((sounding > 400000)) || failed "only $sounding bytes of the file are not zero"

ALSOFT_DRIVERS=none "$thaum" --demo --seconds 5 >"$folder/out" 2>"$folder/said" ||
    failed "the match without a sound device ended with an error"
[ "$(wc -l <"$folder/said")" -eq 1 ] && grep -q '^no sound: ' "$folder/said" ||
    { cat "$folder/said"; failed "a missing device is told in one line"; }
echo "heard"
