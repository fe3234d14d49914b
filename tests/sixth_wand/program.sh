#!/usr/bin/env bash
# program.sh THAUM_WITH_HAIL THAUM ASSETS: the whole program with the sixth wand. Bots use it in a match, its log
# replays and names the wand and its events. The program without the wand refuses that log by the wand's name.
set -euo pipefail
with_hail=$1 without=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY
cp -r "$3" "$folder/assets"
cp "$(dirname "$0")/hail.toml" "$folder/assets/wands/"
failed() {
    echo "failed: $1"
    exit 1
}

export THAUM_ASSETS=$folder/assets
"$with_hail" --headless --seconds 40 --bots 3,3 --seed 3 --out "$folder" >"$folder/said" || failed "no match: $(cat "$folder/said")"
log=$folder/duel.thaumlog
"$with_hail" replay "$log" --verify --events "$folder/events.csv" || failed "the log does not replay"
"$with_hail" replay "$log" --header | grep -i hail || failed "the header does not name the wand"
grep -m 3 hail_ "$folder/events.csv" || failed "no lump of hail hit or chilled anybody"
! "$without" replay "$log" --verify 2>"$folder/refusal" || failed "a program without the wand replays the log"
cat "$folder/refusal"
grep -q hail "$folder/refusal" || failed "the refusal does not name the wand"
