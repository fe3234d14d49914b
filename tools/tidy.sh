#!/usr/bin/env bash
# tools/tidy.sh [SOURCE...]: checks the named sources of ours with clang-tidy, each on its own. Without a name, it checks all
# in batches, as the build makes them but without precompiled headers, and then compiles each source on its own with them:
# a source must include all that it uses, also when the batches are cut anew.
#
# This is slow, so what passed is remembered under a key: in build/tidy (or THAUM_BUILD/tidy), and in tools/tidied.txt,
# which is committed, so that a fresh checkout reads only what changed since. The key is a hash of everything that the batch
# or source depends on: the settings, the command that compiles it, and the text of its sources and of every header of ours
# that they include, each without its comments and without the place of the checkout.
set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
build=${THAUM_BUILD:-$root/build}
cache=$build/tidy
list=$root/tools/tidied.txt
mkdir -p "$cache"

# configured NAME OPTION...: makes the build folder tidy-NAME, for its compile database, and prints the folder's name.
configured() {
    local folder=$build/tidy-$1
    if [[ ! -f $folder/build.ninja ]] || ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
        rm -rf "$folder"  # the folder may have come with a tree that was moved or copied
        cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
            -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DTHAUM_PORTABLE=ON -DBUILD_TESTING=ON "${@:2}" \
            >"$folder.log" 2>&1 || { cat "$folder.log" >&2; exit 1; }
    else
        # Brings the list of sources up to date.
        ninja -C "$folder" build.ninja >"$folder.log" 2>&1 || { cat "$folder.log" >&2; exit 1; }
    fi
    echo "$folder"
}

sources_in() { sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$1/compile_commands.json" | sort -u; }

# Reads names of sources, and prints lines "SOURCE TAB FILE": each file of ours on which a source depends, the source
# included. Includes are written from the root, from engine/ or tests/, or beside the file.
dependencies() {
    awk -v root="$root/" '
        function exists(file,    line, found) {
            if (!(file in known)) { found = (getline line < file); close(file); known[file] = found >= 0 }
            return known[file]
        }
        function place(name, from,    folder, i) {
            if (name ~ /^\//) return name
            folder = from; sub(/[^\/]*$/, "", folder)
            if (exists(folder name)) return folder name
            for (i = 1; i <= 3; ++i) if (exists(root where[i] name)) return root where[i] name
            return ""
        }
        # Prints each file that a source reaches.
        function follow(source, file,    i, line, count) {
            if ((source, file) in seen) return
            seen[source, file] = 1
            print source "\t" file
            if (!(file in includes)) {
                includes[file] = 0
                while ((getline line < file) > 0) {
                    if (line !~ /^ *# *include *"/) continue
                    sub(/^ *# *include *"/, "", line); sub(/".*/, "", line)
                    line = place(line, file)
                    if (line != "") included[file, ++includes[file]] = line
                }
                close(file)
            }
            count = includes[file]
            for (i = 1; i <= count; ++i) follow(source, included[file, i])
        }
        BEGIN { where[1] = ""; where[2] = "engine/"; where[3] = "tests/" }
        { follow($0, $0) }'
}

# commands FOLDER: prints lines "SOURCE TAB COMMAND": how the build folder compiles each source, without its output.
commands() {
    awk '/^ *"command": / { command = $0; sub(/^ *"command": "/, "", command); sub(/ -o .*/, "", command) }
        /^ *"file": / {
            file = $0; sub(/^ *"file": "/, "", file); sub(/".*/, "", file)
            gsub(/\\\\/, "\\", command); gsub(/\\"/, "\"", command)
            print file "\t" command
        }' "$1/compile_commands.json"
}

# without_comments FOLDER: reads names of files, copies them into the folder without their comments, and prints lines
# "COPY TAB FILE". A changed comment changes no finding of clang-tidy, unless it is one that clang-tidy obeys (NOLINT) or
# makes a function longer: so an empty line stays for each line of comment. The files of a batch name its sources with the
# path of this tree, which is left out.
without_comments() {
    awk -v folder="$1" -v root="$root" -v build="$build/" '
        # A line without its comment. One within text, after an odd number of quotation marks, is none.
        function code_of(line,    at, from, quoted) {
            for (from = 1; at = index(substr(line, from), "//"); from += at + 1) {
                quoted = substr(line, 1, from + at - 2)
                gsub(/\\"/, "", quoted)
                if (gsub(/"/, "", quoted) % 2 == 0 && line !~ /\\$/) {
                    line = substr(line, 1, from + at - 2)
                    sub(/ +$/, "", line)
                    return line
                }
            }
            return line
        }
        {
            copy = sprintf("%s/%06d", folder, NR)
            printf "" >copy
            while ((getline line <$0) > 0) {
                if (index($0, build) == 1) gsub(root, "", line)
                else if (line ~ /\/\// && line !~ /NOLINT/) line = code_of(line)
                print line >copy
            }
            close(copy)
            close($0)
            print copy "\t" $0
        }'
}

# keys FOLDER: reads names of sources and prints lines "KEY TAB SOURCE".
keys() {
    local common
    # Only the version is used, because the other lines name this machine's processor.
    common=$({ clang-tidy --version | grep version && cat "$root/.clang-tidy"; } | sha256sum | cut -c1-16)
    commands "$1" >"$cache/commands"
    dependencies >"$cache/dependencies"
    # One hash for each file, then for each source a hash of the hashes of its files.
    cut -f2 "$cache/dependencies" | sort -u >"$cache/files"
    rm -rf "$cache/code"
    mkdir "$cache/code"
    without_comments "$cache/code" <"$cache/files" >"$cache/copies"
    cut -f1 "$cache/copies" | xargs -r -d '\n' sha256sum | cut -c1-64 | paste -d ' ' - /dev/null <(cut -f2 "$cache/copies") \
        >"$cache/hashes"
    # Writes all that a source depends on into a small file of its own, so that one call hashes them all.
    rm -rf "$cache/texts"
    mkdir "$cache/texts"
    awk -F '\t' -v common="$common" -v root="$root" -v place="$cache/texts" '
        FNR == 1 { ++file }
        file == 1 { hash[substr($0, 67)] = substr($0, 1, 64); next }
        file == 2 { command[root $1] = $2; next }
        { all[$1] = all[$1] hash[$2] }
        END {
            for (source in all) {
                text = sprintf("%s/%06d", place, ++count)
                printf "%s%s%s%s", common, command[source], all[source], substr(source, length(root) + 1) >text
                close(text)
                print source
            }
        }' "$cache/hashes" <(sed "s|$root||g" "$cache/commands") "$cache/dependencies" >"$cache/sources_of_texts"
    sha256sum "$cache/texts"/* | cut -c1-16 | paste - "$cache/sources_of_texts"
}

# tidy_one FOLDER SOURCE: runs clang-tidy over a source, or a batch.
tidy_one() {
    local output
    output=$(clang-tidy --quiet -p "$1" --extra-arg=-Wno-error --extra-arg=-Wno-unknown-warning-option "$2" 2>&1) && return
    printf '%s\n' "$output" | grep -v -e 'warnings generated' -e '^Suppressed' -e '^Use -header-filter'
    return 1
}

# compile_one FOLDER SOURCE: compiles a source on its own by the command that `keys` has found, without making code.
compile_one() { bash -c "$(awk -F '\t' -v source="$2" '$1 == source { print $2; exit }' "$cache/commands") -fsyntax-only '$2'"; }

# find_new FOLDER NAME: reads names of sources and writes their keys to the file NAME. Keys that are not known to pass
# go into the file `new`, each followed by its source on a line of its own.
find_new() {
    local key source
    keys "$1" >"$cache/$2"
    while IFS=$'\t' read -r key source; do
        [[ -e $cache/$key ]] || printf '%s\n' "$key" "$source"
    done <"$cache/$2" >"$cache/new"
    cut -f1 "$cache/$2" | (cd "$cache" && xargs -r touch -c)  # so that keys in use are not deleted as old
    echo "$2: $(wc -l <"$cache/$2"), $(($(wc -l <"$cache/new") / 2)) of them new or changed"
}

# check_one CHECK FOLDER KEY SOURCE: remembers the key if the check passes.
check_one() { "$1" "$2" "$4" && : >"$cache/$3"; }

# check_new CHECK FOLDER: runs a check on each key and source in the file `new`.
# shellcheck disable=SC2016  # $@ belongs to the inner shell
check_new() { xargs -r -d '\n' -n 2 -P "$(nproc)" bash -c 'check_one "$@"' check_one "$@" <"$cache/new"; }
export -f check_one tidy_one compile_one
export cache

if (($# > 0)); then
    folder=$(configured named -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_UNITY_BUILD=OFF)
    readlink -f "$@" | find_new "$folder" sources
    check_new tidy_one "$folder"
    exit
fi

# Keys of sources that passed in another checkout count as passed here.
[[ ! -r $list ]] || awk '$1 ~ /^[0-9a-f]+$/ { print $1 }' "$list" | (cd "$cache" && xargs -r touch)
find "$cache" -type f -mtime +30 -delete
batches=$(configured batches -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON)
sources_in "$batches" | find_new "$batches" batches
check_new tidy_one "$batches"
alone=$(configured alone -DCMAKE_UNITY_BUILD=OFF)
# Sources that cmake makes for the precompiled headers are left out.
sources_in "$alone" | grep -v "^$alone/" | find_new "$alone" sources
if [[ -s $cache/new ]]; then
    ninja -C "$alone" -t targets all | sed -n 's/^\(.*\.pch\): .*/\1/p' | xargs -d '\n' ninja -C "$alone" >"$alone.log" ||
        { cat "$alone.log" >&2; exit 1; }
fi
check_new compile_one "$alone"
# All sources have passed, so the list is written anew.
{
    echo "# Batches and sources that passed, written by tools/tidy.sh: the hash of all that they depend on, and their names."
    cat "$cache/batches" "$cache/sources" | sort -k 2 | tr '\t' ' ' | sed "s|$batches/||; s|$root/||"
} >"$list"
