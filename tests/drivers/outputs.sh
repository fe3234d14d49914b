#!/usr/bin/env bash
# tests/drivers/outputs.sh THAUM: no output may destroy an input. Each writing command gets as output its own
# input, other names of that input, another recording, and places where nothing can be written. It must refuse
# in one line with exit code 2 and leave all files unchanged.
set -uo pipefail
. "$(dirname "$0")/offscreen.sh"
thaum=$(readlink -f "$1")
work_in_new_folder
export THAUM_ASSETS=$folder/assets
cp -r "$repository/assets" assets

"$thaum" --headless --seconds 2 --out made >/dev/null || { echo "failed: no recording"; exit 1; }
"$thaum" bench primitives --quick --json report >/dev/null 2>&1 || { echo "failed: no report"; exit 1; }
"$thaum" lab --fluid --headless --cells 16 --seconds 0.1 --save brew >/dev/null || { echo "failed: no brew"; exit 1; }
printf 'time_s,x_m,y_m,z_m\n0,0.5,-0.2,0\n0.5,-0.5,-0.3,0.4\n' >path.csv
cp "$repository/tests/scenarios/panic_key.lua" script.lua
"$thaum" gesture generate --users 2 --samples 1 --out made >/dev/null || { echo "failed: no strokes"; exit 1; }
mv made/strokes.csv strokes.csv
mv made/duel.thaumlog log
cp log other
mkdir kept
cp log other report brew path.csv script.lua strokes.csv kept/

restore() {
    rm -rf log other report brew path.csv script.lua strokes.csv hard soft outputs
    cp kept/* .
    ln log hard
    ln -s log soft
}

# unharmed WHAT: checks that the inputs are unchanged and that there is no half-written file.
unharmed() {
    local file
    for file in log other report brew path.csv script.lua strokes.csv; do
        cmp -s "$file" "kept/$file" && continue
        fail "$1: $file was destroyed"
        cp "kept/$file" "$file"
    done
    [[ -z $(find . -name '*.part') ]] || fail "$1: leaves $(find . -name '*.part')"
}

# refused WORDS COMMAND...: expects one line with these words and exit code 2 within 10 s.
refused() {
    local words=$1 output status
    shift
    output=$(timeout 600 "$thaum" "$@" 2>&1 >/dev/null </dev/null)
    status=$?
    [[ $status == 2 && $output == *"$words"* && $(grep -c . <<<"$output") == 1 ]] ||
        fail "thaum $*: exit $status, said: ${output:0:300}"
    unharmed "thaum $*"
}

# ---- commands that write a file: the input and the words; @ stands for the output --------------------------

league="league --bots 1,2 --matches 20 --seed 5 --json @"
writers=(
    "log replay log --events @"
    "log replay log --state @"
    "log replay log --forces @"
    "log replay log --verify --events @"
    "log replay log --verify --state @ --every 100"
    "log replay log --dump 1000 @"
    "script.lua scenario script.lua --out outputs --json @"
    "- $league"
    "- bench fluid --json @"
    "- doctor --json @"
    "brew lab --fluid --headless --seconds 3 --load brew --save @"
    "brew lab --fluid --headless --seconds 3 --load brew --trace @"
    "path.csv lab --fluid --headless --seconds 3 --stir path.csv --save @"
    "strokes.csv gesture eval strokes.csv --json @"
    "strokes.csv gesture eval strokes.csv --svg @"
    "strokes.csv gesture spot path.csv --labels script.lua --train strokes.csv --json @"
    "strokes.csv gesture record circle --strokes strokes.csv --out @"
)
# All writers follow the same rule (core/write_rule.h). So the first writer is tried with every name of its
# input and every bad place, the others with some.
for row in "${writers[@]}"; do
    input=${row%% *}
    words=${row#* }
    names=("$input" other_name) recordings=(other) places=(/proc/x missing/file)
    if [[ $row == "${writers[0]}" ]]; then
        names+=("./$input" link "$folder/../$(basename "$folder")/$input")
        places+=(/dev/full log/file "$folder")
    fi
    [[ $input != script.lua ]] || recordings+=(hard soft)
    if [[ $input != - ]]; then
        restore
        ln "$input" other_name
        ln -s "$input" link
        for name in "${names[@]}"; do
            # shellcheck disable=SC2086
            refused "is read by this command" ${words//@/$name}
        done
        rm other_name link
    fi
    restore
    for name in "${recordings[@]}"; do
        # shellcheck disable=SC2086
        refused "is a recording" ${words//@/$name}
    done
    for name in "${places[@]}"; do
        # shellcheck disable=SC2086
        refused "$name: cannot" ${words//@/$name}
    done
done
restore
refused "exists" --headless --seconds 1 --record log
bolt=$(cat assets/wands/bolt.toml)
refused "is read by this command" replay log --events assets/wands/bolt.toml
refused "is read by this command" replay log --events assets/wands/new.toml
[[ $(cat assets/wands/bolt.toml) == "$bolt" ]] || fail "a data file was destroyed"
refused "both write" replay log --events same --state same
refused "both write" lab --fluid --headless --seconds 3 --save same --trace ./same
refused "both write" gesture eval strokes.csv --json same --svg ./same

# ---- commands that fill a folder: one of their files, which is a link to a recording, and the words --------

fillers=(
    "duel.png shots log --out @"
    "shot_00000000.png replay log --shots @ --size 64x64"
    "replay_0.png replay log --out @"
    "replay_0.dump replay log --out @"
    "lab_0000001.png lab --fluid --headless --cells 16 --seconds 0.1 --every 1 --size 64x64 --shots @"
    "index.html plot report --out @"
    "duel.png --headless --seconds 1 --out @"
    "duel.txt --headless --seconds 1 --out @"
)
for row in "${fillers[@]}"; do
    # shellcheck disable=SC2086
    words=${row#* }
    restore
    mkdir outputs
    ln other "outputs/${row%% *}"
    # shellcheck disable=SC2086
    refused "is a recording" ${words//@/outputs}
    restore
    for place in /dev/full /proc/x log/below; do
        # shellcheck disable=SC2086
        refused "$place: cannot" ${words//@/$place}
    done
done
for place in /proc/x log/below; do refused "$place: cannot" scenario script.lua --out "$place"; done
# The force trace of a scenario, the player's settings and the program are inputs too.
mkdir -p tests/scenarios tests/replays/forces config/thaum
cp script.lua tests/scenarios/panic_key.lua
cp "$repository/tests/replays/forces/panic_key.csv" tests/replays/forces/
cp assets/settings.toml config/thaum/settings.toml
cp "$thaum" program
spares() { # FILE COMMAND...: expects that the command is refused and leaves FILE unchanged
    local file=$1 before status
    shift
    before=$(md5sum <"$file")
    said=$("$@" 2>&1)
    status=$?
    [[ $status == 2 && $(md5sum <"$file") == "$before" ]] || fail "$file was replaced or not refused: exit $status, $said"
}
spares tests/replays/forces/panic_key.csv \
    "$thaum" scenario tests/scenarios/panic_key.lua --once --out outputs --json tests/replays/forces/panic_key.csv
spares config/thaum/settings.toml "$thaum" doctor --json config/thaum/settings.toml
spares program ./program replay log --events program
rm -r tests config program outputs
# A scenario that cannot write its files has failed.
mkdir outputs
ln other outputs/script.json
said=$("$thaum" scenario script.lua --out outputs --once 2>&1)
[[ $? == 1 && $said == *"is a recording"* ]] || fail "a scenario's own file: $said"
unharmed "a scenario's own file"

# ---- a folder without write permission; root needs another user for this test ------------------------------

if [[ $(id -u) == 0 ]] && command -v setpriv >/dev/null; then
    restore
    chmod 755 "$folder" && mkdir -m 755 locked
    for words in "replay $folder/log --state locked/f" "doctor --json locked/f" "shots $folder/log --out locked" \
        "scenario $folder/script.lua --out locked" "plot $folder/report --out locked" "--headless --out locked"; do
        # shellcheck disable=SC2086
        output=$(setpriv --reuid=65534 --clear-groups "$thaum" $words 2>&1 >/dev/null </dev/null)
        [[ $? == 2 && $output == *"locked"*"Permission denied"* && $(grep -c . <<<"$output") == 1 ]] ||
            fail "thaum $words, in a locked folder: $output"
    done
    [[ -z $(ls locked) ]] || fail "a locked folder was written"
    unharmed "a locked folder"
fi

# ---- files that may be replaced, and standard output -------------------------------------------------------

restore
echo old >table
"$thaum" replay log --events table >/dev/null || fail "an old table is not replaced"
[[ $(head -c 4 table) != "old"* && $(stat -c %h log) == 2 ]] || fail "the old table stays"
echo old >goal && ln -s goal table_link
"$thaum" replay log --events table_link >/dev/null || fail "a link to an old table"
[[ -L table_link && $(head -c 3 goal) != old ]] || fail "a link was replaced instead of what it leads to"
for words in "replay log --verify" "doctor --json -" "bench primitives --quick --json -" "scenario script.lua --once --json -" \
    "league --bots 1,2 --matches 2 --set quick.seconds=3 --json -" "--headless --seconds 1" "replay --help"; do
    # shellcheck disable=SC2086
    output=$("$thaum" $words 2>&1 >/dev/full </dev/null)
    [[ $? == 2 && $output == *"cannot write to standard output"* ]] || fail "thaum $words >/dev/full: said ${output:0:200}"
done
# Names from outside may hold control codes of a terminal. No output may hold them.
for words in "check odd" "--headless --seconds 1 --out odd" "replay odd/duel.thaumlog --dump 5 odd/d" "doctor" "odd" "--odd"; do
    THAUM_ASSETS=$([[ $words == doctor ]] && echo $'/gone/\e[2J' || echo "$folder/assets") XDG_CONFIG_HOME=$'/gone/\e[2J' \
        "$thaum" ${words//odd/$'\e[2J'} >said 2>&1 </dev/null
    ! grep -q $'\e' said || fail "thaum $words: sends a command to the terminal: $(cat -v said)"
    grep -qF '\x1b[2J' said || fail "thaum $words: hides a control character: $(cat -v said)"
done

ln -s /proc/self/fd/1 standard_output
"$thaum" replay log --events standard_output >said 2>line && fail "a table over its own standard output"
unharmed "at the end"

((failures == 0)) && echo "no output destroyed an input"
exit $((failures > 0))
