#!/usr/bin/env bash
# program.sh THAUM_WITH_MEND THAUM ASSETS: the whole program with the fifth spell. Bots cast it in a match by strokes, its
# log replays and names the spell. The program without the spell refuses that log by the spell's name.
set -euo pipefail
with_mend=$1 without=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY
cp -r "$3" "$folder/assets"
cp "$(dirname "$0")/mend.toml" "$folder/assets/spells/"
cp "$(dirname "$0")/w.toml" "$folder/assets/gestures/"
failed() {
    echo "failed: $1"
    exit 1
}

export THAUM_ASSETS=$folder/assets
"$with_mend" --headless --seconds 40 --bots 3,3 --seed 3 --out "$folder" >"$folder/said" || failed "no match: $(cat "$folder/said")"
log=$folder/duel.thaumlog
"$with_mend" replay "$log" --verify --events "$folder/events.csv" || failed "the log does not replay"
"$with_mend" replay "$log" --header | grep -i mend || failed "the header does not name the spell"
grep -m 3 ",cast,.*,mend," "$folder/events.csv" || failed "no bot cast the spell"
! "$without" replay "$log" --verify 2>"$folder/refusal" || failed "a program without the spell replays the log"
cat "$folder/refusal"
grep -q mend "$folder/refusal" || failed "the refusal does not name the spell"
