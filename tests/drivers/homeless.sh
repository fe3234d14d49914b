#!/usr/bin/env bash
# tests/drivers/homeless.sh THAUM: if the log cannot be stored, the match is still played, and one line says
# why.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
need Xvfb
thaum=$(readlink -f "$1")
open_screen 640x360
mkdir "$folder/here"
cd "$folder/here"
export XDG_DATA_HOME=/proc/x XDG_CONFIG_HOME=/proc/x
status=0
said=$(timeout 600 "$thaum" --demo --seconds 1 2>&1 >/dev/null) || status=$?
[[ $status == 0 && $(grep -c 'this match is not recorded: /proc/x/thaum/matches' <<<"$said") == 1 ]] ||
    { echo "failed: an unwritable data folder: exit $status: $said"; exit 1; }
status=0
said=$(timeout 600 "$thaum" --demo --seconds 1 --record /proc/x/log 2>&1 >/dev/null) || status=$?
[[ $status == 2 && $said == *"cannot create"* ]] || { echo "failed: a log asked for by name: $status: $said"; exit 1; }
[[ -z $(ls -A) ]] || { echo "failed: it leaves $(ls -A) where it was started"; exit 1; }
echo "played without a log"
