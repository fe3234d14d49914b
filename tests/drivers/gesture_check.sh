#!/usr/bin/env bash
# tests/drivers/gesture_check.sh THAUM: the shipped gestures do not collide, in any order; a gesture beside its own copy
# does. The generator writes the shipped files again, bit for bit, and its users' strokes can be evaluated.
set -euo pipefail
thaum=$(readlink -f "$1")
gestures=$(readlink -f "$(dirname "$0")/../../assets/gestures")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "failed: $1"; exit 1; }

"$thaum" gesture check "$gestures"/*.toml || fail "two shipped gestures collide"
"$thaum" gesture check "$gestures"/{circle,v,s,star}.toml >/dev/null || fail "two shipped gestures collide in the order of the game"
sed 's/^name = "v"/name = "tick"/' "$gestures/v.toml" >"$folder/tick.toml"
if "$thaum" gesture check "$gestures/v.toml" "$folder/tick.toml" >"$folder/said"; then fail "a copy does not collide"; fi
grep -q ' collide$' "$folder/said" || fail "a collision is not named"

"$thaum" gesture generate --out "$folder/made" --users 4 --samples 2 >"$folder/said"
grep -q '4 gestures, 64 strokes and 64 scribbles of 4 users' "$folder/said" || fail "said: $(cat "$folder/said")"
for file in circle v s star; do
    cmp "$folder/made/$file.toml" "$gestures/$file.toml" || fail "$file.toml is not what the generator writes"
done
"$thaum" gesture eval "$folder/made/strokes.csv" --protocol user-dependent --templates 1 --repeats 1 >"$folder/said"
grep -q '64 strokes, 4 gestures, 4 users' "$folder/said" || fail "said: $(cat "$folder/said")"
grep -q '1 template a gesture, 1 repeat, ' "$folder/said" || fail "said: $(cat "$folder/said")"
"$thaum" gesture eval "$folder/made/strokes.csv" --templates 1 --repeats 1 --open-set 0.5 >"$folder/said"
grep -q ' of 32 trials of known gestures; 32 of unknown ones$' "$folder/said" || fail "said: $(cat "$folder/said")"
"$thaum" gesture eval "$folder/made/strokes.csv" --method early --at 0.05 --repeats 1 >"$folder/said"
grep -q '^told early *in none of the trials$' "$folder/said" || fail "said: $(cat "$folder/said")"
"$thaum" gesture record v --strokes "$folder/made/strokes.csv" --count 1 --out "$folder/one.toml" >"$folder/said"
grep -q "^1 stroke of 'v'$" "$folder/said" || fail "said: $(cat "$folder/said")"
# A stroke of one point is refused, and the message names its line in the file that is read.
printf 'user,gesture,sample,t,x,y\na,dot,1,0,0,0\na,line,1,0,0,0\na,line,1,1,1,0\na,dot,2,0,0,0\n' >"$folder/dots.csv"
if "$thaum" gesture record dot --strokes "$folder/dots.csv" --out "$folder/dot.toml" >"$folder/said" 2>&1; then fail "a dot is a gesture"; fi
grep -q 'dots.csv:5: a stroke needs two points or more$' "$folder/said" || fail "said: $(cat "$folder/said")"
"$thaum" gesture generate --out "$folder/other" --users 1 --samples 1 --seed 2 >/dev/null
if cmp -s "$folder/other/v.toml" "$gestures/v.toml"; then fail "another seed draws the same strokes"; fi
echo "shipped gestures are apart, and the generator makes them"
