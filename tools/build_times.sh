#!/usr/bin/env bash
# tools/build_times.sh BUILD [OLDER_TABLE]: prints the table tools/build_times.txt, by which ./thaum shows the progress of
# a build: tenths of a second that each step of the build folder BUILD took last. Run it after a whole build with
# `ninja -j2` on a quiet machine of two cores. Steps that only the older table has are kept. The row "configure" is the
# time of cmake, by which the launcher knows how fast its machine is.
set -euo pipefail
build=$1
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
began=${EPOCHREALTIME/./}
cmake -S "$root" --preset release -B "$scratch" -DBUILD_TESTING=OFF >/dev/null
configure=$(((${EPOCHREALTIME/./} - began) / 100000))
echo "# Tenths of a second of a core for each step of a build, measured by tools/build_times.sh."
{
    [[ -z ${2:-} ]] || grep -v '^#' "$2" || true
    echo "$configure configure"
    awk -F '\t' '!/^#/ && $4 ~ /\.(o|gch|pch|a|so)$|\/thaum(-tools)?$/ { print int(($2 - $1) / 100), $4 }' "$build/.ninja_log"
} | awk '{ time[$2] = $1 } END { for (step in time) if (time[step] > 0) print time[step], step }' | sort -k2
