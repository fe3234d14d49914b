#!/usr/bin/env bash
# tests/drivers/duel_to_death.sh THAUM PAD_HARNESS [SCREENSHOTS]: the program as two people use it, under Xvfb: player 2
# turns with the pad's stick and shoots player 1 dead; player 1 comes back on the pad opposite and shoots back with the
# mouse. The log must say 1 : 1 and replay to the same bits. Exits 77 where a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 harness=$2
need Xvfb xdotool import umockdev-wrapper
open_screen 1280x720
shots=${3:-$folder}
# A stick so slow that two seconds of it are known to a fifth of a degree, though the machine be late by a hundredth of one.
mkdir -p "$folder/config/thaum"
sed 's/^turn_deg_per_s = .*/turn_deg_per_s = 22.5/' "$(dirname "$0")/../../assets/settings.toml" \
    >"$folder/config/thaum/settings.toml"

# Both start 30 m apart, turned 45 degrees away from each other, towards the cauldron.
script='7 rx 32767; 9 rx 0; 9.5 rt 255; 13 rt 0'
umockdev-wrapper "$harness" "$script" "$thaum" --vs --seconds 22 --record "$folder/log" \
    --set bolt.shot.damage=40 --set bolt.shot.spread_deg=0.2 &
game=$!
sleep 13.5
import -window root "$shots/player_1_is_dead.png"
sleep 3
xdotool mousedown 1
sleep 3
xdotool mouseup 1
import -window root "$shots/player_2_is_dead.png"
wait "$game"

result=$("$thaum" replay "$folder/log" --verify)
echo "$result"
grep -q 'score 1 : 1' <<<"$result" || { echo "failed: not one kill each"; exit 1; }
