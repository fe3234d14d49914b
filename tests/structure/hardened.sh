#!/usr/bin/env bash
# tests/structure/hardened.sh FOLDERS PROGRAM...: each program is built as CMakePresets.json asks (THAUM_HARDENED). None of the
# folders, which are separated by colons, may be named in it.
set -euo pipefail
IFS=: read -r -a folders <<<"$1"
shift
failures=0

# expect PROGRAM NAME CONDITION...: prints whether the condition holds.
expect() {
    if "${@:3}"; then
        echo "ok: $1 $2"
    else
        echo "FAILED: $1 $2"
        failures=$((failures + 1))
    fi
}
has() { readelf -W "$1" "$program" | grep -cE "$2" >/dev/null; }
lacks() { ! has "$@"; }
names() { grep -qaF -e "$1" "$program"; }
does_not_name() { ! names "$1"; }

for program in "$@"; do
    name=$(basename "$program")
    expect "$name" "is loaded at an address of chance" has -h 'Type: +DYN'
    expect "$name" "has a part that is read-only after the start" has -l ' GNU_RELRO '
    expect "$name" "and finds all functions before that" has -d '\(FLAGS_1\).* NOW'
    expect "$name" "has a stack on which nothing is executed" has -l ' GNU_STACK .* RW '
    expect "$name" "has nothing that is both written and executed" lacks -l ' RWE '
    expect "$name" "looks for overruns of the stack" has --dyn-syms ' __stack_chk_fail'
    expect "$name" "and of what library calls fill" has --dyn-syms ' __(mem|str|fread|read|v?s?n?printf)[a-z]*_chk'
    for folder in "${folders[@]}"; do expect "$name" "does not name $folder" does_not_name "$folder"; done
done
((failures == 0))
