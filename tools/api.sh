#!/usr/bin/env bash
# tools/api.sh FOLDER: writes web pages of the engine's public headers to FOLDER/html with doxygen. Every type and function
# there needs a doc comment, or is listed and fails the command. A struct's fields may share the comment of the struct, and
# constructors, operators and the functions of a standard container or allocator (`size`, `begin`, ...) need none. Without
# doxygen, the command says so and returns 77.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
out=${1:?usage: tools/api.sh FOLDER}
command -v doxygen >/dev/null || { echo "doxygen is not installed."; exit 77; }
mkdir -p "$out"
said=$out/said.txt
cd "$root"

# doxygen leaves out what stands in a namespace without a comment. So each namespace gets one, the row of the
# table in engine/README.md.
{
    echo '/** @namespace thaum'
    echo ' Thaum: all that programs use of the engine. Ticks, maths, errors and files (engine/core) stand in it directly. */'
    sed -nE '/engine.core/d; s!^\| `engine/(\w+)` \| ([^|]*) \|.*!/** @namespace thaum::\1\n \2. */!p' engine/README.md
    echo '/** @namespace thaum::det'
    echo ' Functions of core/maths.h that have the same bits on every processor. */'
} >"$out/namespaces.h"

doxygen - <<SETTINGS
PROJECT_NAME = "Thaum's engine"
OUTPUT_DIRECTORY = $out
INPUT = engine $out/namespaces.h
FILE_PATTERNS = *.h *.md
RECURSIVE = YES
EXCLUDE_PATTERNS = */detail/* */examples/*
EXCLUDE_SYMBOLS = *::detail
USE_MDFILE_AS_MAINPAGE = engine/README.md
STRIP_FROM_PATH = engine
STRIP_FROM_INC_PATH = engine
GENERATE_LATEX = NO
HAVE_DOT = NO
JAVADOC_AUTOBRIEF = YES
MULTILINE_CPP_IS_BRIEF = YES
DISTRIBUTE_GROUP_DOC = YES
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = THAUM_COMPONENT(...)= THAUM_FIELDS(...)= THAUM_FIELDS_OF(...)=
QUIET = YES
WARN_IF_UNDOCUMENTED = YES
WARN_IF_INCOMPLETE_DOC = NO
WARN_FORMAT = "\$file:\$line: \$text"
WARN_LOGFILE = $said
SETTINGS

free='~?[A-Z][A-Za-z0-9]*\(|operator|(size|empty|data|begin|end|front|back|reset|get|clear|allocate|deallocate)\('
missing=$(sed -n "s|^$root/||; s/ is not documented.$//p" "$said" | grep -vE '\((variable|enumvalue|friend)\) of' |
    grep -vE "Member ($free)" || true)

# A comment stands for all overloads of the function below it: names of documented functions, with their files.
documented=$(find engine -name '*.h' -not -path '*/detail/*' -print0 | xargs -0 awk '
    /^ *\/\/\// { after = 1; next }
    after || /\/\/\/</ { if (match($0, /[a-z_0-9]+\(/)) print FILENAME ":" substr($0, RSTART, RLENGTH) }
    { after = after && /(^ *template|^ *requires[^;{]*|[^;{}])$/ && !/\(/ }')
missing=$(awk -v documented="$documented" '
    BEGIN { n = split(documented, list, "\n"); for (i = 1; i <= n; ++i) known[list[i]] = 1 }
    { file = $1; sub(/:.*/, "", file); name = $4; sub(/\(.*/, "(", name); if (!((file ":" name) in known)) print }' <<<"$missing")
if [[ -n $missing ]]; then
    echo "$missing"
    echo "$(wc -l <<<"$missing") types and functions have no doc comment."
    exit 1
fi
