#!/usr/bin/env bash
# tests/drivers/lab_files.sh THAUM: files of `thaum lab VOLUME` without a window. No output may destroy a file
# that the command reads: a volume beside the first, one of a session, samples of a detached header, colours
# and materials. The same holds if the output is another name of such a file. Two outputs need two files.
# Faults on the command line are told in one line.
set -uo pipefail
. "$(dirname "$0")/offscreen.sh"
thaum=$(readlink -f "$1")
work_in_new_folder
export THAUM_ASSETS=$repository/assets

short=(--headless --seconds 0.02)
"$thaum" lab sphere --count 16 "${short[@]}" --save a.nrrd >/dev/null || { echo "failed: no body"; exit 1; }
"$thaum" lab sphere --count 12 --headless --seconds 0.3 --mode isosurface --carve paint,0,1 --save b.nrrd >/dev/null
[[ -f b.colour.nrrd ]] || { echo "failed: no colours"; exit 1; }
head -c 4096 /dev/zero | tr '\0' '\5' >samples.nrrd
printf 'NRRD0004\ntype: uchar\ndimension: 3\nsizes: 16 16 16\nencoding: raw\ndata file: samples.nrrd\n' >detached.nhdr
cp samples.nrrd raw.bin
printf 'version = 1\nfile = "raw.bin"\nsizes = [16, 16, 16]\ntype = "uint8"\nspacing_mm = [1, 1, 1]\n' >raw.toml
printf 'version = 1\nvolume = "a.nrrd"\nopacity = [0, 0]\n[[beside]]\nvolume = "b.nrrd"\n' >session.toml
ln a.nrrd hard.nrrd
ln -s b.colour.nrrd soft.nrrd
mkdir kept
cp -a ./*.* kept/

# refused WORDS ARGUMENT...: expects one line with these words and exit code 2, and all files unchanged.
refused() {
    local words=$1 output status file
    shift
    output=$("$thaum" lab "$@" 2>&1 >/dev/null </dev/null)
    status=$?
    [[ $status == 2 && $output == *"$words"* && $(grep -c . <<<"$output") == 1 ]] ||
        fail "thaum lab $*: exit $status, said: ${output:0:300}"
    for file in kept/*; do
        cmp -s "$file" "$(basename "$file")" && continue
        fail "thaum lab $*: $(basename "$file") was destroyed"
        cp -a "$file" .
    done
    [[ $(find . -maxdepth 1 -name '*.*' -type f | wc -l) == $(find kept -type f | wc -l) ]] ||
        fail "thaum lab $*: leaves another file"
}

read="is read by this command"
for output in "--save a.nrrd" "--trace a.nrrd" "--save hard.nrrd" "--trace hard.nrrd" "--trace ./kept/../a.nrrd"; do
    # shellcheck disable=SC2086
    refused "$read" sphere --count 16 --beside a.nrrd "${short[@]}" --carve melt,0,1 $output
    # shellcheck disable=SC2086
    refused "$read" --session session.toml "${short[@]}" --carve melt,0,1 $output
done
for output in "--save b.nrrd" "--trace b.nrrd"; do
    # shellcheck disable=SC2086
    refused "$read" --session session.toml "${short[@]}" $output
done
refused "$read" raw.toml --trace raw.bin "${short[@]}"
refused "$read" raw.toml --trace raw.toml "${short[@]}"
refused "$read" detached.nhdr --save samples.nrrd "${short[@]}"
for output in "--save b.colour.nrrd" "--trace b.colour.nrrd" "--trace soft.nrrd" "--save b.material.nrrd"; do
    # shellcheck disable=SC2086
    refused "$read" b.nrrd "${short[@]}" $output
done
refused "both write" b.nrrd "${short[@]}" --save x.nrrd --trace x.colour.nrrd
refused "both write" b.nrrd "${short[@]}" --save x.nrrd --trace ./x.material.nrrd

# ---- words -------------------------------------------------------------------------------------------------

cp a.nrrd kept/a.nrrd
refused "--hand nix.csv: cannot open" a.nrrd "${short[@]}" --hand nix.csv
refused "there are " a.nrrd "${short[@]}" --device nix
refused "there are " a.nrrd "${short[@]}" --device ../wands/bolt
refused "from -1 to 1" a.nrrd "${short[@]}" --place 1e9,0,0
refused "from 0.05 to 20" a.nrrd "${short[@]}" --place 0,0,0,360
refused "from -360 to 360" a.nrrd "${short[@]}" --place 0,0,0,1,361
refused "from 0 to 1" a.nrrd "${short[@]}" --opacity 0:-1
refused "in digits alone" sphere "${short[@]}" --seed 1e12
refused "--registered needs --beside" a.nrrd "${short[@]}" --registered
refused "b.nrrd: it can be registered only if" a.nrrd "${short[@]}" --beside b.nrrd --registered
printf 'NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1 64 64\nencoding: raw\ndata file: samples.nrrd\n' >flat.nhdr
cp flat.nhdr kept
refused "flat.nhdr: the volume needs two samples" flat.nhdr "${short[@]}"
printf 'NRRD0004\ntype: float\ndimension: 3\nsizes: 16 8 8\nencoding: raw\nendian: little\ndata file: faulty.bin\n' >faulty.nhdr
{ head -c 4092 /dev/zero; printf '\0\0\300\177'; } >faulty.bin
cp faulty.* kept
[[ $("$thaum" lab faulty.nhdr "${short[@]}") == "faulty.nhdr: 1 of 1024 samples are no finite numbers"* ]] ||
    fail "samples that are no numbers are not told"
for ((i = 0; i < 1024; ++i)); do printf '\0\0\300\177'; done >faulty.bin
cp faulty.* kept
refused "none of its 1024 samples is a finite number" faulty.nhdr "${short[@]}"
[[ $("$thaum" help lab) == "$("$thaum" lab --help)" && $("$thaum" help lab) == usage* ]] || fail "thaum help lab"
[[ $("$thaum" help nix 2>&1) == *"unknown command 'nix'"* ]] || fail "thaum help nix"

[[ $failures == 0 ]] && echo "all files are safe" || exit 1
