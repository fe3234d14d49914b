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

# compiles COMPILER OPTION...: tests whether the compiler accepts padding.cpp with these options.
compiles() { "$1" -std=c++20 -fsyntax-only -I"$engine" "${@:2}" "$components" >"$output" 2>&1; }

# is_refused COMPONENT: tests whether the compiler's output names the line that asks for the component's
# description.
is_refused() {
    local line
    line=$(grep -n "component_info<$1>" "$components" | cut -d: -f1)
    grep -q "$(basename "$components"):$line:" "$output"
}

# try NAME COMPILER...: tests the first of these compilers that is installed.
try() {
    local name=$1 compiler component
    shift
    compiler=$(command -v "$@" | head -n 1) || true
    if [[ -z $compiler ]]; then
        echo "skipped: no $name"
        skipped=77
        return
    fi
    compiles "$compiler" || failed "$name refuses a component without padding"
    ! compiles "$compiler" -DPADDED || failed "$name accepts padding"
    for component in PaddedInside PaddedAtTheEnd HoldsPadded UnlistedField ListedTwice LongDouble; do
        is_refused "$component" || failed "$name accepts $component"
    done
    [[ $(grep -c 'error: static.assert' "$output") == 6 ]] ||
        failed "$name refuses a component for another reason"
    echo "$name: padding is refused"
}

try GCC g++
# clang-tidy comes with a clang++ that has its version in its name.
try clang clang++ clang++-14
exit ${skipped:-0}
