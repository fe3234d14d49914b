#!/bin/sh
# same_output.sh PROGRAM PROGRAM: both print the same and succeed.
set -eu
first=$("$1")
second=$("$2")
[ -n "$first" ]
[ "$first" = "$second" ] || { printf '%s\n--- differs from ---\n%s\n' "$first" "$second"; exit 1; }
