#!/usr/bin/env bash
# tests/drivers/stalled.sh SESSION LOG_PROBE: two bots in a window under Xvfb while one thread after the other is held up.
# Each log must play again to the same hashes; a stall beyond 250 ms must leave samples out and say so in the log.
set -euo pipefail
session=$1 probe=$2
command -v Xvfb >/dev/null || { echo "skipped: no Xvfb"; exit 77; }
folder=$(mktemp -d)
server=
trap '[ -n "$server" ] && kill "$server"; rm -rf "$folder"' EXIT
Xvfb -displayfd 3 -screen 0 640x360x24 3>"$folder/display" 2>/dev/null &
server=$!
for _ in $(seq 100); do
    [ -s "$folder/display" ] && break
    sleep 0.05
done
DISPLAY=:$(cat "$folder/display")
export DISPLAY

try() { # NAME THREAD EVERY_MS MS
    "$session" "$folder/$1" 4 bot bot "$2" "$3" "$4"
    "$probe" "$folder/$1" | tee "$folder/$1.txt"
    grep -q 'replay same' "$folder/$1.txt" || { echo "failed: $1"; exit 1; }
}
try main main 200 150
try render render 200 150
try late simulation 300 80
try skipped simulation 1000 600
grep -q 'device 0: .* skips [1-9]' "$folder/skipped.txt" || { echo "failed: nothing left out"; exit 1; }
echo "stalls change no result"
