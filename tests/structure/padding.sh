#!/usr/bin/env bash
# tests/structure/padding.sh ENGINE PADDING_CPP: a component with padding is a compile error, under GCC and under clang.
# Exits with 77 (skipped) if one of them is missing, after it has tried the other.
set -euo pipefail
engine=$1 components=$2
skipped=
output=$(mktemp)
trap 'rm -f "$output"' EXIT

failed() {
    echo "failed: $1"
    cat "$output"
    exit 1
}

# compiles COMPILER COMPONENT
compiles() {
    "$1" -std=c++20 -fsyntax-only -I"$engine" -DCOMPONENT="$2" "$components" >"$output" 2>&1
}

# is_refused COMPILER COMPONENT: the compiler names a requirement that does not hold, and not something else.
is_refused() {
    ! compiles "$1" "$2" && grep -Eq 'constraints not satisfied|static.assert' "$output"
}

# try NAME COMPILER...: the first of the compilers that is there.
try() {
    local name=$1 compiler component
    shift
    compiler=$(command -v "$@" | head -n 1) || true
    if [[ -z $compiler ]]; then
        echo "skipped: no $name"
        skipped=77
        return
    fi
    compiles "$compiler" Tight || failed "$name refuses a component without padding"
    for component in PaddedInside PaddedAtTheEnd HoldsPadded UnlistedField ListedTwice LongDouble; do
        is_refused "$compiler" "$component" || failed "$name accepts $component, or refuses it for another reason"
    done
    echo "$name: padding is refused"
}

try GCC g++
# clang-tidy comes with a clang++ that has its version in its name.
try clang clang++ clang++-14
exit ${skipped:-0}
