#!/usr/bin/env bash
# tests/drivers/hostile_files.sh THAUM [all]: whatever stands in the place of a file, its reader must refuse
# it at once in one line with exit code 2. A disk that fills up during a recording may cost the rest of the
# log and nothing else. Two programs may record into one folder. Each of ten kinds of wrong files replaces a
# quarter of the data files, so that each data file is replaced by two or three kinds; with "all", each kind
# replaces each of them.
set -uo pipefail
thaum=$(readlink -f "$1") one_in=4
[[ ${2:-} != all ]] || one_in=1
repository=$(readlink -f "$(dirname "$0")/../..")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY
export XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data
failures=0
fail() { echo "failed: $1"; failures=$((failures + 1)); }
# limited COMMAND...: runs a command that may compute for 5 s, or for $THAUM_PATIENCE_S in sanitizer and debug
# builds, which start slowly. A busy machine may make it wait, so the limit of real time only ends a command
# that hangs.
limited() ( ulimit -t "${THAUM_PATIENCE_S:-5}" && exec timeout 600 "$@" )

# put KIND PLACE: puts an object of that kind in the place of a file.
put() {
    rm -rf "$2"
    case $1 in
        empty) : >"$2" ;;
        huge) truncate -s 10G "$2" ;;
        directory) mkdir "$2" ;;
        fifo) mkfifo "$2" ;;
        device) ln -s /dev/zero "$2" ;;
        itself) ln -s "$2" "$2" ;;
        noise) head -c 100000 /dev/urandom >"$2" ;;
        zeros) head -c 100000 /dev/zero >"$2" ;;
        long_line) { printf 'version = '; head -c 900000 /dev/zero | tr '\0' 9; } >"$2" ;;
        deep) { printf 'version = 1\na = '; head -c 400000 /dev/zero | tr '\0' '['; } >"$2" ;;
    esac
}

# refused WHAT COMMAND...: expects one line on standard error and exit code 2, in limited time and memory.
refused() {
    local what=$1 output status
    shift
    output=$(cd "$folder" && ulimit -v "${THAUM_MEMORY_KB:-2000000}" && limited "$thaum" "$@" 2>&1 >/dev/null </dev/null)
    status=$?
    [[ $status == 2 && $(grep -c . <<<"$output") == 1 && ${#output} -lt 600 ]] ||
        fail "$what: thaum $* gave $status: ${output:0:300}"
}

# kept WHAT: expects one line about unreadable settings, which must stay unchanged. The program must go on,
# here up to the missing display.
kept() {
    local said status settings=$folder/config/thaum/settings.toml before
    before=$(stat -c '%F %s %Y' "$settings")
    said=$(DISPLAY=:4242 limited "$thaum" --demo 2>&1 >/dev/null </dev/null)
    status=$?
    [[ $status == 2 && $said == *"cannot open a window"* && $(stat -c '%F %s %Y' "$settings") == "$before" ]] &&
        [[ $(head -n 1 <<<"$said") == *"it is kept as it is, and the defaults hold" ]] &&
        (($(grep -c . <<<"$said") <= 2 && ${#said} < 800)) || fail "$1: gave $status: ${said:0:400}"
}

data_files=(arenas/boiling_court.toml rules/quick.toml wizards/wizard.toml wands/bolt.toml wands/blast.toml wands/lob.toml
    bots/level_1.toml haptics.toml cauldron.toml orb.toml crystal.toml carving/melt.toml devices/touch.toml)
cp -r "$repository/assets" "$folder/assets"
turn=0
for kind in empty huge directory fifo device itself noise zeros long_line deep; do
    put "$kind" "$folder/log"
    refused "$kind log" replay "$folder/log" --verify
    refused "$kind log" shots "$folder/log" --out "$folder/out"
    refused "$kind dump" diff "$folder/log" "$folder/log"
    put "$kind" "$folder/script.lua"
    # A scenario that cannot be read has failed.
    said=$(cd "$folder" && limited "$thaum" scenario "$folder/script.lua" 2>&1 </dev/null)
    status=$?
    [[ ($status == 1 || $status == 2) && $(grep -c . <<<"$said") == 1 && ${#said} -lt 600 ]] ||
        fail "$kind scenario: gave $status: ${said:0:300}"
    for file in "${data_files[@]}"; do
        ((turn++ % one_in == 0)) || continue
        mv "$folder/assets/$file" "$folder/kept"
        put "$kind" "$folder/assets/$file"
        THAUM_ASSETS=$folder/assets refused "$kind $file" --headless --seconds 1 --out "$folder/out"
        rm -rf "$folder/assets/$file"
        mv "$folder/kept" "$folder/assets/$file"
    done
    mv "$folder/assets/range.toml" "$folder/kept"
    put "$kind" "$folder/assets/range.toml"
    THAUM_ASSETS=$folder/assets refused "$kind range.toml" range --headless --seconds 1
    rm -rf "$folder/assets/range.toml"
    mv "$folder/kept" "$folder/assets/range.toml"
    mkdir -p "$folder/config/thaum"
    put "$kind" "$folder/config/thaum/settings.toml"
    kept "$kind settings"
    rm -rf "$folder/config"
done

# A disk that fills up: the log may not grow beyond 16 KiB.
(cd "$folder" && ulimit -f 16 && "$thaum" --headless --seconds 30 --record "$folder/full.thaumlog" --out "$folder/out" >"$folder/said" 2>"$folder/line")
status=$?
[[ $status == 1 ]] || fail "full disk: exit code $status"
grep -q 'full.thaumlog: recording stopped: .*kept up to tick' "$folder/line" || fail "full disk: said $(cat "$folder/line")"
grep -q '^result ' "$folder/said" || fail "full disk: the match did not go on to its end"
kept=$(sed -n 's/.*kept up to tick \([0-9]*\).*/\1/p' "$folder/line")
"$thaum" replay "$folder/full.thaumlog" --verify >"$folder/verified" 2>/dev/null || fail "full disk: the log does not replay"
grep -q "^$kept ticks, " "$folder/verified" || fail "full disk: kept $kept, replayed $(cat "$folder/verified")"
((kept > 1000)) || fail "full disk: kept only $kept ticks"

# A picture that cannot be saved is a fault of the run, although its log is whole. A log of 3 s has 5 KiB.
(cd "$folder" && ulimit -f 64 && "$thaum" --headless --seconds 3 --out "$folder/small" >"$folder/said" 2>"$folder/line")
status=$?
if ! grep -q '^picture .*none: cannot draw' "$folder/said"; then
    [[ $status == 1 ]] || fail "no room for the picture: exit code $status"
    grep -q 'duel.png' "$folder/line" || fail "no room for the picture: said $(cat "$folder/line")"
fi
"$thaum" replay "$folder/small/duel.thaumlog" --verify >/dev/null || fail "no room for the picture: the log"

# A disk that is full from the start.
refused "full device" --headless --seconds 1 --out /dev/full
"$thaum" --headless --seconds 2 --out "$folder/good" >/dev/null
log=$folder/good/duel.thaumlog
refused "device as table" replay "$log" --events /dev/full
refused "device as dump" replay "$log" --dump 5 /dev/null
refused "folder as table" replay "$log" --state "$folder"
[[ -c /dev/full && -c /dev/null ]] || fail "a device was replaced"

# Several programs record at once under one name: exactly one may get it.
mkdir -p "$XDG_DATA_HOME"
for run in 1 2 3 4; do
    "$thaum" --headless --seconds 1 --record "$folder/shared.thaumlog" --out "$folder/out$run" >/dev/null 2>"$folder/line$run" &
done
wait
[[ $(cat "$folder"/line[1-4] | grep -c 'never overwritten') == 3 ]] || fail "four programs, one name: $(cat "$folder"/line[1-4])"
"$thaum" replay "$folder/shared.thaumlog" --verify >/dev/null || fail "the log of the one that got the name"

# No further thread can be started: commands must use fewer workers, or say in one line that they need one.
limited() {
    if [[ $(id -u) != 0 ]]; then
        (ulimit -u 1 && "$thaum" "$@")
    else
        setpriv --reuid=65534 --clear-groups prlimit --nproc=1 "$thaum" "$@"
    fi
}
if [[ ${THAUM_MEMORY_KB:-} != unlimited ]] && { [[ $(id -u) != 0 ]] || command -v setpriv prlimit; } >/dev/null; then
    chmod 755 "$folder" && mkdir -m 777 "$folder/anybody"
    export THAUM_ASSETS=$folder/assets
    said=$(limited --headless --seconds 1 --out "$folder/anybody" 2>&1 >/dev/null)
    status=$?
    [[ $status == 2 && $said == *"no further thread"* && $(grep -c . <<<"$said") == 1 ]] ||
        fail "no thread for the log: $status: $said"
    limited diff "$log" --threads 1,2 | grep -q 'no difference' || fail "no threads to compare with"
    limited lab --fluid --headless --cells 16 --seconds 0.1 --threads 2 >/dev/null || fail "no thread for the brew"
    said=$(limited bench tick --stress --ticks 500 2>&1 >/dev/null)
    status=$?
    [[ $status -lt 3 && $said != *terminate* ]] || fail "no thread for a bench: $status: $said"
    unset THAUM_ASSETS
fi

# lined WORDS: expects exit code 2 and one line with WORDS: file, line and the value that does not fit another
# file.
lined() {
    local said
    said=$(THAUM_ASSETS=$folder/assets "$thaum" --headless --seconds 1 --out "$folder/out" 2>&1 >/dev/null)
    [[ $? == 2 && $said == *"$1"* && $(grep -c . <<<"$said") == 1 ]] || fail "wanted '$1': $said"
}
cp -r "$folder/assets" "$folder/sound_assets"
again() { rm -rf "$folder/assets" && cp -r "$folder/sound_assets" "$folder/assets"; }
arena=$folder/assets/arenas/boiling_court.toml
line=$(grep -n '^ingredient' "$arena" | head -n 1 | cut -d: -f1)
sed -i "${line}s/=.*/= \"gold\"/" "$arena"
lined "arenas/boiling_court.toml:$line: niche: cauldron.toml has no ingredient 'gold'"
again
line=$(grep -n '^device' "$folder/assets/haptics.toml" | cut -d: -f1)
for device in ../x nothing; do
    sed -i "${line}s|=.*|= \"$device\"|" "$folder/assets/haptics.toml"
    lined "haptics.toml:$line: device '$device'"
done
again

# Two replays of a log must write tables with the same bytes.
for run in 1 2; do
    "$thaum" replay "$log" --verify --events "$folder/e$run" --state "$folder/s$run" --every 7 >/dev/null || fail "tables"
done
cmp -s "$folder/e1" "$folder/e2" && cmp -s "$folder/s1" "$folder/s2" || fail "two runs gave different tables"
[[ $(wc -l <"$folder/s1") == 287 ]] || fail "rows of the state: $(wc -l <"$folder/s1")"

((failures == 0)) && echo "every file was refused in one line"
exit $((failures > 0))
