#!/usr/bin/env bash
# tests/drivers/stalled.sh SESSION LOG_PROBE: two bots in a window under Xvfb while one thread is stalled.
# Each log must replay with equal hashes. A stall beyond 250 ms must skip samples and say so in the log.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
session=$1 probe=$2
need Xvfb
open_screen 640x360

try() { # NAME THREAD EVERY_MS MS: stalls that thread for MS every EVERY_MS, and replays the log
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
