#!/usr/bin/env bash
# tests/drivers/range.sh THAUM PRESS_KEYS [range]: the range under Xvfb with mouse and keys, on a copy of the data files. The
# dummy is shot. A step of the Apprentice is done, and one skipped. A file is edited meanwhile and read again, and a faulty
# file is named. A recorded match must ignore changed files, and its log must replay. With "range", the Apprentice and the
# match are left out. Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 press_keys=$2 only=${3:-}
need Xvfb xdotool
open_screen 1280x720
few_pictures
cp -r "$(dirname "$0")/../../assets" "$folder/assets"
export THAUM_ASSETS=$folder/assets
bolt=$folder/assets/wands/bolt.toml
fail() { failed "$1"; }
at_failure() { cat "$folder/said"; picture failed; }
drawn() { [ "$(colours 400x100+100+500)" -gt 100 ]; }
said() { grep -q "$1" "$folder/said"; }

# 1. Shoots, and edits a file as editors do: a new file renamed over the old one. Then makes it faulty.
"$thaum" range --seconds 60 >"$folder/said" 2>&1 &
game=$!
eventually "no window" drawn
sed 's/^damage = 6/damage = 50/' "$bolt" >"$bolt.new"
mv "$bolt.new" "$bolt"
eventually "the file was not read" said '^read wands/bolt.toml$'
xdotool mousedown 1
sleep 2
xdotool mouseup 1
picture range
sed -i 's/^damage = 50/damage = -50/' "$bolt"
eventually "the wrong file was not named" said "bolt.toml:10: 'damage' is -50"
presses Escape
eventually "no pause of the range" paused
presses q
wait "$game" || fail "the exit code of the range"
grep -Eq '^range: [1-9][0-9]* of [1-9][0-9]* hit' "$folder/said" || fail "nothing was hit"
grep -Eq 'hit .*, [0-9]*[05]0 HP, [1-9][0-9]* kill' "$folder/said" || fail "not by the new damage"
[ -z "$(find "$folder/data" -name '*.thaumlog' 2>/dev/null)" ] || fail "the range was recorded"
[ "$only" != range ] || exit 0

# 2. The Apprentice: the first step is done by keys and mouse, the second one is skipped in the pause.
cp "$(dirname "$0")/../../assets/wands/bolt.toml" "$bolt"
"$thaum" range --apprentice >"$folder/said" 2>&1 &
game=$!
eventually "no first step" said '^apprentice: 1 of [0-9]*: '
eventually "no window of the Apprentice" drawn
looks_and_walks() {
    xdotool keydown w mousemove_relative 150 0
    sleep 0.3
    xdotool keyup w keydown s
    sleep 0.3
    xdotool keyup s
    said '^apprentice: 2 of '
}
eventually "the first step was not done" looks_and_walks
presses Escape
eventually "no pause of the Apprentice" pause_menu
choose 'Skip this step'
presses Return
eventually "the second step was not skipped" said '^apprentice: 3 of '
eventually "the pause of the Apprentice is still there" no_pause_menu
picture apprentice
presses Escape
eventually "no second pause of the Apprentice" pause_menu
presses q
wait "$game" || fail "the exit code of the Apprentice"
said '^apprentice: left at 3 of ' || fail "the end of the Apprentice is not told"
! said '^range: ' || fail "the Apprentice ends with a score of the range"

# 3. A recorded match reads no file again.
"$thaum" --solo 1 --seconds 4 --record "$folder/log" >"$folder/said" 2>&1 &
game=$!
eventually "no window of the match" drawn
sed -i 's/^damage = 6/damage = 50/' "$bolt"
sleep 1.5
sed -i 's/^damage = 50/damage = 6/' "$bolt"
wait "$game" || fail "the exit code of the match"
said 'read ' && fail "a recorded match read a file again"
"$thaum" replay "$folder/log" --verify >"$folder/said" || fail "the log does not play again"
echo "the range is shot on, and reads its files again; a recorded match does not"
