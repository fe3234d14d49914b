#!/usr/bin/env bash
# tests/drivers/fake_phantom_feels.sh THAUM FAKE_HD FORGE_LOG: `thaum replay LOG --feel` with our fake
# libHD.so. In every tick the arm must exert the force that --forces writes. Ctrl-C and a fault of the arm
# must end it without a remaining force, and impossible requests must be refused in one line. No display.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
thaum=$1 fake=$2 forge=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY
export XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data

"$thaum" --headless --seconds 8 --seed 3 --bots 2,2 --out "$folder" >/dev/null
log=$folder/duel.thaumlog
"$thaum" replay "$log" --forces "$folder/forces.csv" >/dev/null

# feel NAME FAKE_HD WORDS...: feels the log. $folder/NAME.exerted gets the forces of the arm,
# $folder/NAME.said the output.
feel() {
    local name=$1 told=$2
    shift 2
    THAUM_LIBHD=$fake FAKE_HD="$told,record=$folder/$name.exerted" "$thaum" replay "$log" --feel "$@" >"$folder/$name.said" 2>&1
}

# compare PLAYER: checks that the arm exerted the forces of the table in the same order. A tick without a new force
# repeats the last force. A busy machine may keep the arm's thread from running. The program then says how many ticks it
# missed, and in how many ticks the force was held back because the pose was stale. Forces may be smaller than the
# table's in that many ticks only, and in the 50 ticks in which a force returns after them.
compare() {
    local stale missed
    stale=$(sed -n 's/.*stale \([0-9]*\).*/\1/p' "$folder/$1.said")
    missed=$(sed -n 's/.* ticks, \([0-9]*\) missed.*/\1/p' "$folder/$1.said")
    [[ $missed ]] || failed "does not say what was missed"
    awk -F, -v name="p$1_fx_n" '
        NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) column = i; next }
        { print $column, $(column + 1), $(column + 2) }' "$folder/forces.csv" |
        awk -v OFMT=%.17g -v late="$((${stale:-0} + missed))" '
            NR == FNR { wanted[n++] = $1 " " $2 " " $3; next }
            { arm[m++] = $1 " " $2 " " $3 }
            function near(a, b,   x, y) {
                split(a, x, " "); split(b, y, " ")
                return (x[1] - y[1]) ^ 2 + (x[2] - y[2]) ^ 2 + (x[3] - y[3]) ^ 2 < 1e-24
            }
            function size(a,   x) { split(a, x, " "); return x[1] ^ 2 + x[2] ^ 2 + x[3] ^ 2 }
            # Tests whether ten forces of the table from index W on, or all up to its end, equal the forces of
            # the arm from index A on.
            function agree(w, a,   i) {
                for (i = 0; i < 10 && w + i < n; i++) if (a + i >= m || !near(wanted[w + i], arm[a + i])) return 0
                return 1
            }
            # Skips forces of the table that the arm held back, and ticks without a new force among them.
            # Returns whether the forces agree after that.
            function pass_held_back(   k, without) {
                for (k = 1; k <= late + 50; k++)
                    for (without = 0; repeated + without <= 20; without++)
                        if (agree(w + k, a + k + without)) {
                            w += k; a += k + without - 1; held += k; runs++; repeated += without
                            return 1
                        }
                return 0
            }
            END {
                for (w = 0; w < n && size(wanted[w]) == 0;) w++
                for (a = 0; a < m && size(arm[a]) == 0;) a++
                first = w
                for (; w < n && a < m; a++) {
                    if (near(wanted[w], arm[a])) { w++; continue }
                    if (late > 0 && pass_held_back()) continue
                    if (a > 0 && near(arm[a], arm[a - 1])) { repeated++; continue }
                    print "force", w, "is", wanted[w], "the arm exerts", arm[a]; exit 1
                }
                print n - first, "forces, from", first, "on, at the arm as in the table;", repeated + 0, "repeated;", held + 0, "held back"
                if (n == first || w < n || repeated > 20 || held > late + 50 * runs) exit 1
            }' - "$folder/$1.exerted"
}

# Each run takes as long as the log, and spends most of that time waiting for ticks. So all run at once, each
# with an arm of its own.
mkdir -p "$folder/softly/thaum"
echo 'version = 1
force_1 = "soft"' >"$folder/softly/thaum/settings.toml"
declare -A pids
for player in 1 2; do feel $player "" Touch --player $player & pids[$player]=$!; done
XDG_CONFIG_HOME=$folder/softly feel soft "" phantom & pids[soft]=$!
XDG_CONFIG_HOME=$folder/softly feel warm felt,warm=1500 F0000001 --at 2 & pids[warm]=$!
XDG_CONFIG_HOME=$folder/softly feel vanish felt,vanish=1500 phantom --at 2 & pids[vanish]=$!

for player in 1 2; do
    wait ${pids[$player]} || { cat "$folder/$player.said"; failed "does not play"; }
    cat "$folder/$player.said"
    grep -q "player $player's forces on Touch F0000001, at most 1.4[89] of 3.3 N" "$folder/$player.said" || failed "does not say what it does"
    compare $player || failed "other forces"
done

# A lower cap must give weaker forces, never stronger ones. A player who wants no force must feel none.
wait ${pids[soft]} || failed "does not play softly"
awk '{ size = sqrt($1 ^ 2 + $2 ^ 2 + $3 ^ 2); if (size > most) most = size } END { print "softly at most", most, "N"; exit !(most > 0 && most <= 0.825 + 1e-9) }' \
    "$folder/soft.exerted" || failed "the cap does not hold"
grep -q 'capped' "$folder/soft.said" || failed "does not say what was held back"

# ends NAME CODE WORDS: checks the exit code, the output, and that the arm was released without force.
ends() {
    local name=$1 code=0
    wait ${pids[$name]} || code=$?
    cat "$folder/$name.said"
    [ "$code" -eq "$2" ] || failed "exit $code instead of $2"
    grep -q "$3" "$folder/$name.said" || failed "does not say '$3'"
    grep -q 'at most 0.8' <(tail -n +2 "$folder/$name.said") || failed "nothing was felt before"
    tail -n 1 "$folder/$name.exerted" | awk '{ exit !($1 == 0 && $2 == 0 && $3 == 0) }' || failed "a force stays"
}
THAUM_LIBHD=$fake FAKE_HD="record=$folder/stop.exerted,live=$folder/stop.live" XDG_CONFIG_HOME=$folder/softly \
    "$thaum" replay "$log" --feel touch --at 2 >"$folder/stop.said" 2>&1 &
pids[stop]=$!
# Tests whether the largest force so far (a field of FakeHdLive) is above 0.8 N.
was_felt() { od -An -tf8 -j24 -N8 "$folder/stop.live" 2>/dev/null | awk '{ exit !($1 > 0.8) }'; }
eventually "nothing is felt" was_felt
kill -INT ${pids[stop]}
ends stop 0 'ended by hand'
awk '$1 != 0 || $2 != 0 || $3 != 0 { felt = 1 } { ticks += felt } END { exit !(ticks < 6000) }' "$folder/stop.exerted" ||
    failed "goes on after Ctrl-C"
ends warm 1 'too warm'
ends vanish 1 'plug it in'

refuses() { # WORDS ARGUMENT...: expects one line with WORDS and exit code 2
    local words=$1 said code=0
    shift
    said=$(THAUM_LIBHD=$fake "$thaum" replay "$log" "$@" 2>&1) || code=$?
    echo "$said"
    [ "$code" -eq 2 ] || failed "exit $code"
    [ "$(wc -l <<<"$said")" -eq 1 ] || failed "more than a line"
    grep -q -e "$words" <<<"$said" || failed "does not say '$words'"
}
refuses "found Touch F0000001" --feel falcon
refuses "real time only" --feel phantom --speed 2
refuses "--player needs --feel" --player 2
refuses "does not go with" --feel phantom --verify
refuses "from 1 to 2" --feel phantom --player 3
refuses "the log has" --feel phantom --at 60
# A replay that differs from the recorded match must be reported as such.
"$forge" early_input "$log" "$folder/forged.thaumlog"
said=$(THAUM_LIBHD=$fake "$thaum" replay "$folder/forged.thaumlog" --feel phantom --at 1 2>&1) && code=0 || code=$?
[[ $code == 1 && $said == *"tick 256: state differs"* ]] || failed "a forged log is felt: exit $code, said: $said"
fake=$folder/none.so refuses "THAUM_LIBHD" --feel phantom
echo 'version = 1
force_1 = "off"' >"$folder/softly/thaum/settings.toml"
XDG_CONFIG_HOME=$folder/softly refuses "you want no forces" --feel phantom
echo "a log is felt"
