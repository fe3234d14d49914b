# tests/drivers/shots.sh: counts the kicks of shots in a table of forces, $folder/NAME.csv, whose log is
# $folder/NAME.thaumlog; to be sourced. $probe: path of live_log_probe.

# shots NAME PLAYER FROM_S: counts the stretches of force in that player's table from FROM_S on. Prints four
# numbers: stretches that are the kick of one shot, which lasts 15 ms and reaches 1.2 N; others at which the
# machine kept the arm or the match waiting; others without that reason; and the largest force (N). The log
# shows the reason: while nobody waits, each tick has a sample of the arm, of a model that is a few ticks old.
# A match that waits for a tenth of a second catches up afterwards: within a few milliseconds of the arm's
# time it plays two shots, whose kicks add up. An arm that waits keeps its force.
shots() {
    "$probe" "$folder/$1.thaumlog" --model-ages >"$folder/$1.ages"
    awk -F, -v name="p$2_fx_n" -v arm="$2" -v from="$3" '
        BEGIN { before = 20; old = 8 }
        FNR == NR { age[$1] = $(1 + arm); next }
        FNR == 1 { for (i = 1; i <= NF; i++) if ($i == name) column = i; next }
        $2 >= from {
            z = $(column + 2)
            if (z > most) most = z
            if (z > 0.05) { if (!ticks++) first = $1; if (z > peak) peak = z; next }
            if (ticks && between) {
                waits = 0
                for (t = first - before; t <= $1; t++) if (age[t] == 0 || age[t] > old) waits = 1
                if (ticks >= 14 && ticks <= 16 && peak > 1.1 && peak < 1.3) kicks++
                else if (waits) held++
                else others++
            }
            between = 1
            ticks = peak = 0
        }
        END { print kicks + 0, held + 0, others + 0, most + 0 }' "$folder/$1.ages" "$folder/$1.csv"
}

# expect_shots NAME PLAYER FROM_S: the forces are the kicks of single shots, except where the machine waited.
expect_shots() {
    local kicks held others most
    read -r kicks held others most <<<"$(shots "$@")"
    echo "$1: player $2 feels $kicks shots from $3 s on, $held others while the machine waited, at most $most N"
    awk -v n="$kicks" -v held="$held" -v others="$others" -v most="$most" \
        'BEGIN { exit !(n >= 3 && others == 0 && most < (held ? 3.3 : 1.3)) }' ||
        failed "the forces are not those of shots: $others without a reason"
}
