#!/usr/bin/env bash
# tests/drivers/commands.sh THAUM: wrong command lines and invalid files. Each must give one line with the
# fault and the right exit code. No command may hang or leave a half-written file.
set -uo pipefail
thaum=$(readlink -f "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY
export XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data
failures=0

# expect CODE 'WORDS IN THE LINE' ARGUMENT...: checks exit code and output of one command.
expect() {
    local code=$1 words=$2 output status
    shift 2
    output=$(cd "$folder" && timeout 600 "$thaum" "$@" 2>&1 >/dev/null </dev/null)
    status=$?
    if [[ $status != "$code" || $output != *"$words"* || $(grep -c . <<<"$output") != 1 ]]; then
        printf 'failed: thaum %s\n  exit %s instead of %s, said: %s\n' "$*" "$status" "$code" "$output"
        failures=$((failures + 1))
    fi
}

expect 2 "unknown option '--frobnicate'" --frobnicate
expect 2 "unknown command 'brew'" brew
expect 2 "--solo: there is no bot 'levle_1'; there are: level_0, level_1, level_2, level_3; did you mean 'level_1'?" --solo levle_1
expect 2 "exclude each other" --vs --demo
expect 2 "must be mouse, half, pad or arm" --vs --hands mouse,foot
expect 2 "--hands takes one or two" --vs --hands mouse,mouse
expect 2 "--hands goes with" --hands pad
expect 2 "one hand" --solo 1 --hands pad,pad
expect 2 "needs a display" --solo 1
expect 2 "range needs a display" range
expect 2 "must be still, strafing or shooting" range --headless --dummy dead
expect 2 "must be mouse, half, pad or arm" range --hands mouse,pad
expect 2 "has its own dummy and arena" range --apprentice --dummy shooting
expect 2 "no --hands" range --headless --hands pad
expect 2 "unknown option '--record'" range --headless --record "$folder/log"
expect 2 "'damage' is -3" range --headless --set bolt.shot.damage=-3
expect 2 "is given twice" --seed 1 --seed 2
expect 2 "needs 1 value" --headless --seconds
expect 2 "must be a number" --headless --seconds nan
expect 2 "no rule set 'quick'; there are: classic, thaum" --headless --rules quick
expect 2 "no match '../x'; there are: quick, standard" --headless --match ../x
expect 2 "no name of an arena" --headless --arena ../boiling_court
expect 2 "there is no arena 'nowhere'; there are: boiling_court, the_well" --headless --arena nowhere
expect 2 "'damage' is -3" --headless --set bolt.shot.damage=-3
expect 2 "has no key 'shot.damge'" --headless --set bolt.shot.damge=3
expect 2 "--set foo=3" --headless --set foo=3
expect 2 "cannot create" --headless --out /dev/null/out
expect 2 "No such file" replay "$folder/none" --verify
expect 2 "not an ordinary file" replay "$folder" --verify
expect 2 "replay needs one log" replay
expect 2 "diff needs two dumps" diff
echo none >"$folder/no.dump"
expect 2 "not a snapshot, or damaged (A is no.dump, B is no.dump)" diff no.dump no.dump
# Sanitizers' builds have no benchmarks.
benchmarks=false
[[ ! -x $(dirname "$thaum")/thaum-bench ]] || benchmarks=true
! $benchmarks || expect 2 "no area" bench nothing
# The benchmarks are a program of their own, so that the players' program does not replace malloc. It must
# report a missing benchmark program. (Clang links the malloc of its address sanitizer into every program.)
symbols=$(nm --defined-only "$thaum" 2>/dev/null || true)
if [[ $symbols != *__asan_init* ]] && grep -qE ' [TW] (malloc|calloc|realloc)$' <<<"$symbols"; then
    echo "failed: players' program replaces malloc"
    failures=$((failures + 1))
fi
mkdir "$folder/alone"
cp "$thaum" "$folder/alone/thaum"
with_benchmarks=$thaum thaum=$folder/alone/thaum
expect 2 "build it" bench ecs
thaum=$with_benchmarks
rm -r "$folder/alone"
expect 2 "--bots needs two bots" --headless --bots 2
expect 2 "there is no bot 'x'" --headless --bots 2,x
expect 2 "is for --demo" --vs --bots 1,2
expect 2 "there is no mutator 'fgo'; there are: everything_heavy, fog, " --headless --mutator fgo
expect 2 "choose one of the two mutators" --headless --mutator low_gravity --mutator everything_heavy
expect 2 "names level_2 twice" league --bots 2,level_2
expect 2 "there is no bot '4'" league --bots 1,4
expect 2 "must be a number" league --matches 0
expect 2 "no rule set" league --rules none
expect 1 "the median round takes 3 s" league --bots 1,2 --matches 2 --set quick.seconds=3 --set quick.boil_over.seconds=0 --check
expect 2 "no scenario 'nothing'" scenario nothing
expect 2 "plot needs one report" plot
expect 2 "not an ordinary file" plot "$folder"
DISPLAY=:4242 expect 2 "cannot open a window" --demo
mkfifo "$folder/fifo"
expect 2 "not an ordinary file" replay "$folder/fifo" --verify
: >"$folder/empty"
expect 2 "empty file" replay "$folder/empty" --verify
truncate -s 10G "$folder/huge"
expect 2 "huge" replay "$folder/huge" --verify

# A valid log, then damaged copies of it.
"$thaum" --headless --seconds 5 --out "$folder/out" >"$folder/said" || { echo "failed: no duel"; exit 1; }
[[ $(grep -c '^player [12]' "$folder/said") == 2 && -s $folder/out/duel.png ]] || { echo "failed: the duel's files"; exit 1; }
# A first start without a display plays a round that somebody wins, here by the first kill. (It would take long with
# sanitizers.)
if $benchmarks; then
    "$thaum" --set quick.kills=1 --out "$folder/first" >"$folder/said" || { echo "failed: no round without a display"; exit 1; }
    grep -q '^no display' "$folder/said" && grep -q '^result .* wins by kills' "$folder/said" && [[ -s $folder/first/duel.png ]] ||
        { cat "$folder/said"; echo "failed: nobody wins the first round"; exit 1; }
fi
log=$folder/out/duel.thaumlog
expect 2 "never overwritten" --headless --seconds 1 --record "$log" --out "$folder/out"
expect 2 "the log has 5000 ticks" replay "$log" --dump 5001 "$folder/dump"
expect 2 "the log has 5.0 s" replay "$log" --at 6
expect 2 "there are mark, shot" replay "$log" --shots shots --shot-on nothing
expect 2 "must be like 1280x720" replay "$log" --shots shots --size 3x3
expect 2 "--size needs --shots" replay "$log" --size 640x360
expect 2 "--shot-at '9': must be a number from 0 to 5" replay "$log" --shots shots --shot-at 9
expect 2 "--every needs --state" replay "$log" --every 5
expect 2 "--at does not go with" replay "$log" --verify --at 3
expect 2 "must be a number from 0.25 to 16" replay "$log" --speed 40
expect 2 "--header goes with no other option" replay "$log" --header --verify
"$thaum" replay "$log" --header >"$folder/header" || { echo "failed: --header"; failures=$((failures + 1)); }
"$thaum" replay "$(dirname "$0")/../replays/bots_rules_1.thaumlog" --header >>"$folder/header"
for line in 'log: format 2, 5000 ticks, 40 hashes' 'physics: Bullet 3' "device 2: bot 'bot 1' of player 2, look" \
    'data file: wands/bolt.toml' 'kind: event 5 death' 'kind: wand 1 bolt' 'log: format 1, ' 'physics: unknown'; do
    grep -q "^$line" "$folder/header" || { echo "failed: --header lacks '$line'"; failures=$((failures + 1)); }
done
expect 2 "shots needs one log" shots "$log"
! $benchmarks || expect 2 "ecs has no stress test" bench ecs --stress
for run in 1 2; do
    "$thaum" replay "$log" --verify --shots "$folder/shots$run" --shot-every 2 --shot-at 0.5 --size 320x180 >/dev/null
done
[[ $(cd "$folder/shots1" && echo *) == "shot_00000000.png shot_00000500.png shot_00002000.png shot_00004000.png" ]] || { echo "failed: the pictures of a replay: $(ls "$folder/shots1")"; failures=$((failures + 1)); }
diff -r "$folder/shots1" "$folder/shots2" || { echo "failed: the same replay gave other pictures"; failures=$((failures + 1)); }
"$thaum" replay "$log" --verify >/dev/null || { echo "failed: its own log differs"; failures=$((failures + 1)); }
size=$(od -An -tu4 -j12 -N4 "$log")
head -c $((size + 24)) "$log" >"$folder/only_header"
said=$("$thaum" replay "$folder/only_header" --verify 2>/dev/null)
[[ $? == 1 && $said == *"nothing was compared"* ]] || { echo "failed: a log of a header alone: $said"; failures=$((failures + 1)); }
head -c 4000 "$log" >"$folder/cut"
expect 0 "cut off after tick" replay "$folder/cut" --verify
cp "$log" "$folder/flipped"
printf '\x41' | dd of="$folder/flipped" bs=1 seek=4000 conv=notrunc 2>/dev/null
expect 1 "damaged" replay "$folder/flipped" --verify

# Changed data files and differing states must be named.
cp -r "$(dirname "$0")/../../assets" "$folder/assets"
echo '# a comment changes no match' >>"$folder/assets/wands/bolt.toml"
THAUM_ASSETS=$folder/assets "$thaum" replay "$log" --verify >/dev/null ||
    { echo "failed: a comment in a data file changes the match"; failures=$((failures + 1)); }
sed -i 's/^damage = 6/damage = 7/' "$folder/assets/wands/bolt.toml"
THAUM_ASSETS=$folder/assets expect 2 "wands/bolt.toml has changed" replay "$log" --verify
cp "$folder/assets/events.toml" "$folder/events.toml"
printf '[rain]\n' >>"$folder/assets/events.toml"
THAUM_ASSETS=$folder/assets expect 2 "assets/events.toml:$(grep -n rain "$folder/assets/events.toml" | cut -d: -f1): 'rain' is no event" --headless --seconds 1
cp "$folder/events.toml" "$folder/assets/events.toml"
sed -i "s/^version = 1/version = 1\ncolour = 3/" "$folder/assets/rules/quick.toml"
THAUM_ASSETS=$folder/assets expect 2 "assets/rules/quick.toml:3: unknown key 'colour'" --headless --seconds 1
"$thaum" replay "$log" --dump 4000 "$folder/a.dump" >/dev/null
"$thaum" replay "$log" --dump 4001 "$folder/b.dump" >/dev/null
"$thaum" diff "$folder/a.dump" "$folder/a.dump" >/dev/null || { echo "failed: a dump differs from itself"; failures=$((failures + 1)); }
said=$("$thaum" diff "$folder/a.dump" "$folder/b.dump")
[[ $? == 1 && $said == *played*"4000 | 4001"* ]] || { echo "failed: diff does not name what differs"; failures=$((failures + 1)); }
"$thaum" diff "$log" --exe "$thaum" | grep -q 'no difference in 5000 ticks' || { echo "failed: diff --exe"; failures=$((failures + 1)); }
"$thaum" diff "$log" --threads 1,2 | grep -q 'no difference' || { echo "failed: diff --threads"; failures=$((failures + 1)); }

# The lab: impossible arguments, and damaged states.
expect 2 "lab takes one volume" lab
expect 2 "lab needs a display" lab sphere
volume=(lab sphere --headless --count 16 --seconds 0.1)
expect 2 "there are follow" "${volume[@]}" --mode nothing
expect 2 "is given twice" "${volume[@]}" --mode surface --mode surface
expect 2 "there is no --mode" "${volume[@]}" --transfer surface,0:1
expect 2 "must be X:Y" "${volume[@]}" --mode surface --transfer surface,0
expect 2 "it begins with the mode" "${volume[@]}" --filter smooth,1
expect 2 "there are annotate" "${volume[@]}" --carve spoon,0,1
expect 2 "a flow cannot be carved" lab vortices --headless --count 16 --carve melt,0,1
expect 2 "must end in .nrrd" "${volume[@]}" --save body.png
expect 2 "volumes are files that end in" lab /tmp --headless
expect 2 "No such file" lab nowhere.nrrd --headless
expect 2 "there is no device 'touch2'; there are falcon" "${volume[@]}" --device touch2
# Without --mode a body's surface is felt, at --level if that is given.
state_of() { "$thaum" lab "$@" --headless --count 16 --seconds 1 | grep '^state '; }
level_felt=$(state_of sphere --level 60)
[[ -n $level_felt && $level_felt == "$(state_of sphere --mode isosurface --level 60)" && $level_felt != "$(state_of sphere)" ]] ||
    { echo "failed: the usual mode of a body, or its level"; failures=$((failures + 1)); }
[[ $(state_of vortices) == "$(state_of vortices --mode follow)" ]] ||
    { echo "failed: the usual mode of a flow"; failures=$((failures + 1)); }
expect 2 "lab needs a display" lab --fluid
brew=(lab --fluid --headless)
for cells in 0 1 3 17 1000000 -16 32x16x32 nan; do
    expect 2 "must be 15, 16, 24, 32, 48 or 64" "${brew[@]}" --cells "$cells"
done
for viscosity in -1 nan 1e12 thick; do
    expect 2 "--viscosity '$viscosity': must be a number from 0 to 1e+06" "${brew[@]}" --viscosity "$viscosity"
done
expect 2 "at most 3 substances" "${brew[@]}" --substance ember --substance salt --substance iron --substance mist
expect 2 "there are ember" "${brew[@]}" --substance gold
expect 2 "must be NAME or NAME,VISCOSITY,WEIGHT,DIFFUSION" "${brew[@]}" --substance ember,1
expect 2 "--substance '-1'" "${brew[@]}" --substance ember,-1,0,0
expect 2 "must be SUBSTANCE,SECOND,LITRES" "${brew[@]}" --pour ember,1
expect 2 "no such substance" "${brew[@]}" --pour mist,1,10
expect 2 "--pour 'nan'" "${brew[@]}" --pour 1,1,nan
expect 2 "must be thaum or classic" "${brew[@]}" --solver jet
expect 2 "must be 2 or 4" "${brew[@]}" --order 3
expect 2 "must be no_slip or free_slip" "${brew[@]}" --edges wet
expect 2 "exclude each other" "${brew[@]}" --bowl --box
expect 2 "--stir takes none, circle, figure8 or a file" "${brew[@]}" --stir square
expect 2 "--every needs --shots" "${brew[@]}" --every 3
expect 2 "--times needs --trace" "${brew[@]}" --times
expect 2 "must be a number from 1 to 2" "${brew[@]}" --threads 3
expect 2 "must be like 1280x720" "${brew[@]}" --shots shots --size 3x3
expect 2 "No such file" "${brew[@]}" --load "$folder/none"
expect 2 "not an ordinary file" "${brew[@]}" --load "$folder/fifo"
expect 2 "does not begin like one" "${brew[@]}" --load "$folder/out/duel.png"
expect 2 "cannot" "${brew[@]}" --seconds 0.1 --save /dev/null/state
printf '0,0,-0.2,0\n0,1,0,0\n' >"$folder/path.csv"
expect 2 "path.csv:2: times must rise" "${brew[@]}" --stir "$folder/path.csv"
printf 'time_s,x_m,y_m,z_m\n0,0.5,-0.2,0\n0.5,-0.5,-0.3,0.4\n' >"$folder/path.csv"
small=("${brew[@]}" --cells 16 --stir "$folder/path.csv" --pour ember,0.1,40 --times)
"$thaum" "${small[@]}" --seconds 0.96 --trace "$folder/whole.csv" --save "$folder/whole" >/dev/null
"$thaum" "${small[@]::9}" --seconds 0.48 --save "$folder/half" >/dev/null
"$thaum" "${brew[@]}" --stir "$folder/path.csv" --load "$folder/half" --seconds 0.48 --threads 2 --save "$folder/both" >/dev/null
cmp -s "$folder/whole" "$folder/both" || { echo "failed: a saved brew goes on otherwise"; failures=$((failures + 1)); }
[[ $(head -1 "$folder/whole.csv") == time_s,energy_m5_s2,*,substance_1_m3,substance_2_m3,substance_3_m3,fluid_us,surface_us && $(wc -l <"$folder/whole.csv") == 61 ]] ||
    { echo "failed: the trace"; failures=$((failures + 1)); }
awk -F, 'END { exit !($2 > 0 && $19 > 0.0399) }' "$folder/whole.csv" || { echo "failed: nothing moved in the trace"; failures=$((failures + 1)); }
for change in --cells=15 --solver=classic --box --edges=free_slip --viscosity=1 --gravity=0 --order=2; do
    "$thaum" "${brew[@]}" --load "$folder/half" ${change/=/ } --seconds 0.1 >"$folder/said" || { echo "failed: $change"; failures=$((failures + 1)); }
done
head -c 5000 "$folder/half" >"$folder/cut_brew"
expect 2 "cut off" "${brew[@]}" --load "$folder/cut_brew" --save "$folder/both"
cp "$folder/half" "$folder/flipped_brew"
printf '\x41' | dd of="$folder/flipped_brew" bs=1 seek=9000 conv=notrunc 2>/dev/null
expect 2 "damaged" "${brew[@]}" --load "$folder/flipped_brew" --save "$folder/both"
cmp -s "$folder/whole" "$folder/both" || { echo "failed: a refused state was saved over another"; failures=$((failures + 1)); }
[[ -z $(find "$folder" -name '*.part*') ]] || { echo "failed: half-written files stay"; failures=$((failures + 1)); }

# A league has the same results with any number of processes.
league=(league --bots 1,3 --matches 3 --set quick.seconds=6 --json -)
[[ $("$thaum" "${league[@]}" --jobs 1) == "$("$thaum" "${league[@]}" --jobs 3)" ]] || { echo "failed: league --jobs"; failures=$((failures + 1)); }

# Gestures: files that are wrong are refused in one line; a network and a gesture file are written whole.
printf 'user,gesture,sample,t,x,y\n' >"$folder/strokes.csv"
for user in 1 2 3; do
    for i in 0 1 2 3 4 5 6 7 8 9; do
        echo "$user,line,0,0.$i,$i,$((user * i))" >>"$folder/strokes.csv"
        echo "$user,hook,0,0.$i,$i,$(((i - 5) * (i - 5)))" >>"$folder/strokes.csv"
    done
done
head -c 100 "$folder/strokes.csv" | gzip | head -c 40 >"$folder/cut.csv.gz"
expect 2 "no action" gesture
expect 2 "unknown action 'draw'" gesture draw
expect 2 "name one file of strokes" gesture eval
expect 2 "must be dot, tdnn, directions, elastic, default or early" gesture eval strokes.csv --method guess
expect 2 "must be a number from 0.05 to 1" gesture eval strokes.csv --at 0
expect 2 "must be user-dependent, leave-user-out or random" gesture eval strokes.csv --protocol best
expect 2 "the file has no force" gesture eval strokes.csv --channels xyf
expect 2 "cut off" gesture eval cut.csv.gz
expect 2 "no column 't_start'" gesture spot strokes.csv --labels strokes.csv --train strokes.csv
expect 2 "no stroke of the gesture 'ring'" gesture record ring --strokes strokes.csv --out "$folder/ring.toml"
expect 2 "at most one of --device, --log and --strokes" gesture record ring --device mouse --strokes strokes.csv --out "$folder/ring.toml"
expect 2 "drawing strokes needs a display" gesture record ring --out "$folder/ring.toml"
expect 2 "name a folder with --out" gesture generate
expect 2 "must be a number from 1 to 1000" gesture generate --out "$folder/made" --users 0
expect 2 "cannot create" gesture generate --out /dev/null/made
expect 2 "No such file" gesture check "$folder/none.toml"
awk 'BEGIN { print "user,gesture,sample,t,x,y"; for (i = 0; i < 100001; i++) print "1,long,0," i / 1000 "," i "," i % 7 }' >"$folder/long.csv"
expect 2 "a stroke of 100001 points, more than 100000" gesture record long --strokes "$folder/long.csv" --out "$folder/long.toml"
printf '%s\n' user,gesture,sample,t,x,y 1,far,0,0,0,0 1,far,0,1,2e9,5 1,far,0,2,3,4 >"$folder/far.csv"
expect 2 "far.csv:2: the stroke has a number beyond 1e9" gesture record far --strokes "$folder/far.csv" --out "$folder/far.toml"
[[ ! -e $folder/long.toml && ! -e $folder/far.toml ]] || { echo "failed: a file that is refused was written"; failures=$((failures + 1)); }
for name in line hook; do "$thaum" gesture record $name --strokes "$folder/strokes.csv" --out "$folder/$name.toml" >/dev/null; done
"$thaum" gesture check "$folder/line.toml" "$folder/hook.toml" >"$folder/check.txt" ||
    { echo "failed: two gestures that differ collide"; failures=$((failures + 1)); }
"$thaum" gesture check "$folder/line.toml" "$folder/line.toml" >"$folder/check.txt"
[[ $? == 1 && $(<"$folder/check.txt") == *collide* ]] || { echo "failed: two equal gestures do not collide"; failures=$((failures + 1)); }
"$thaum" gesture eval "$folder/strokes.csv" --json "$folder/eval.json" --svg "$folder/eval.svg" >/dev/null
grep -q '"accuracy"' "$folder/eval.json" && grep -q '</svg>' "$folder/eval.svg" ||
    { echo "failed: the report of an evaluation"; failures=$((failures + 1)); }

# The sounds as a list, as files and as pictures. A name, a folder or a recipe that is wrong is refused in one line.
expect 2 "no sound 'horn'; \`thaum sounds\` lists them" sounds boil horn
expect 2 "cannot create" sounds boil --out /dev/null/out
expect 2 "/dev/null" sounds boil --sheet /dev/null/sheet.png
[[ $("$thaum" sounds | grep -c '  ') == $(( $(find "$folder/assets/sounds" -name "*.toml" | wc -l) + 1 )) ]] || { echo "failed: thaum sounds does not list each file of assets/sounds"; failures=$((failures + 1)); }
"$thaum" sounds bolt_shot boil --out "$folder/sounds" --sheet "$folder/new/sheet.png" >/dev/null
[[ $(cd "$folder/sounds" && echo *) == "boil.png boil.wav bolt_shot.png bolt_shot.wav" ]] || { echo "failed: the files of two sounds"; failures=$((failures + 1)); }
# The WAV file of a sound of 0.24 s: a header of 58 bytes, then 48,000 samples of four bytes for each second.
[[ $(stat -c %s "$folder/sounds/bolt_shot.wav") == 46138 && -s $folder/new/sheet.png ]] || { echo "failed: the WAV file of a sound, or the sheet"; failures=$((failures + 1)); }
cp -r "$(dirname "$0")/../../assets" "$folder/assets"
echo 'loud = true' >>"$folder/assets/sounds/boil.toml"
THAUM_ASSETS=$folder/assets expect 2 "sounds/boil.toml:" sounds

# All data files: the shipped ones have no fault. Faults of another folder's files are listed, and decide the
# exit code.
"$thaum" check >"$folder/said" || { echo "failed: the shipped data files have faults: $(head -1 "$folder/said")"; failures=$((failures + 1)); }
echo nonsense >"$folder/assets/spells/heal.toml"
"$thaum" check "$folder/assets" >"$folder/said" && { echo "failed: check finds no fault"; failures=$((failures + 1)); }
[[ $(grep -c "^assets/sounds/boil.toml:[0-9]*: unknown key 'parts.loud'\|^assets/spells/heal.toml:1: a line is KEY = VALUE" "$folder/said") == 2 ]] ||
    { echo "failed: check does not list both faults"; failures=$((failures + 1)); }
expect 2 "there is no such folder" check "$folder/none"
THAUM_ASSETS=$folder/none expect 2 "there is no folder $folder/none of data files: set THAUM_ASSETS" --headless --seconds 1

for command in play range lab replay shots diff scenario league bench plot sounds check doctor; do
    [[ $command != bench ]] || $benchmarks || continue
    lines=$("$thaum" "$command" --help | wc -l)
    [[ $lines -gt 2 && $lines -le 26 ]] || { echo "failed: the help of $command has $lines lines"; failures=$((failures + 1)); }
done
((failures == 0)) && echo "all said what is wrong"
exit $((failures > 0))
