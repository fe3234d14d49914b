#!/usr/bin/env bash
# tools/tidy.sh [SOURCE...]: clang-tidy over the named sources of ours, each compiled alone; without a name, over all of
# them, in batches as the build makes them.
#
# clang-tidy is slow, so a batch that passed is remembered under a key: in build/tidy, and in tools/tidied.txt, which is
# committed, so that a fresh checkout reads only what changed since. The key is a hash of everything that the batch
# depends on: the settings, the compiler's command, and the text of its sources and of every header of ours that they
# include, each without the place of the checkout. The build folders of clang-tidy have no precompiled headers, since clang cannot read GCC's, and since a source
# must include all that it uses.
set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
cache=$root/build/tidy
list=$root/tools/tidied.txt
mkdir -p "$cache"

# configured UNITY: makes a build folder with a compile database alone, and prints its name.
configured() {
    local folder=$root/build/tidy-$1
    if [[ ! -f $folder/build.ninja ]]; then
        cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
            -DTHAUM_PORTABLE=ON -DBUILD_TESTING=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_UNITY_BUILD="$1" \
            -DCMAKE_UNITY_BUILD_BATCH_SIZE=32 >"$folder.log" 2>&1 || { cat "$folder.log" >&2; exit 1; }
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

# keys FOLDER: reads names of sources and prints lines "KEY TAB SOURCE".
keys() {
    local common
    common=$({ clang-tidy --version && cat "$root/.clang-tidy" && grep -h '"command"' "$1/compile_commands.json" |
        sed "s/.*\"command\": \"\(.*\) -o .*/\1/; s|$root||g" | sort -u; } | sha256sum | cut -c1-16)
    dependencies >"$cache/dependencies"
    # One hash per file, then per source a hash of its hashes.
    cut -f2 "$cache/dependencies" | sort -u >"$cache/files"
    grep -v "^$root/build/" "$cache/files" | xargs -r -d '\n' sha256sum >"$cache/hashes"
    # A batch names its sources by their places.
    { grep "^$root/build/" "$cache/files" || true; } | while IFS= read -r source; do
        printf '%s  %s\n' "$(sed "s|$root||g" "$source" | sha256sum | cut -c1-64)" "$source"
    done >>"$cache/hashes"
    awk -F '\t' -v common="$common" '
        NR == FNR { hash[substr($0, 67)] = substr($0, 1, 64); next }
        { all[$1] = all[$1] hash[$2] }
        END { for (source in all) print common all[source] "\t" source }' "$cache/hashes" "$cache/dependencies" |
        while IFS=$'\t' read -r text source; do
            printf '%s\t%s\n' "$(printf '%s' "$text${source#"$root"}" | sha256sum | cut -c1-40)" "$source"
        done
}

check_one() {
    local key=${1%%$'\t'*} source=${1#*$'\t'} output
    if output=$(clang-tidy --quiet -p "$folder" --extra-arg=-Wno-error --extra-arg=-Wno-unknown-warning-option \
        --extra-arg=-Wno-unknown-pragmas "$source" 2>&1); then
        : >"$cache/$key"
    else
        printf '%s\n' "$output" | grep -v -e 'warnings generated' -e '^Suppressed' -e '^Use -header-filter'
        return 1
    fi
}
export -f check_one
export root cache folder

if (($# > 0)); then
    folder=$(configured OFF)
    readlink -f "$@" | keys "$folder" >"$cache/keys"
else
    folder=$(configured ON)
    sources_in "$folder" | keys "$folder" >"$cache/keys"
fi
# What passed in another checkout passed here.
[[ ! -r $list ]] || awk '$1 ~ /^[0-9a-f]+$/ { print $1 }' "$list" | (cd "$cache" && xargs -r touch)
while IFS=$'\t' read -r key source; do
    if [[ -e $cache/$key ]]; then touch "$cache/$key"; else printf '%s\t%s\n' "$key" "$source"; fi
done <"$cache/keys" >"$cache/todo"
echo "clang-tidy: $(wc -l <"$cache/keys") sources or batches, $(wc -l <"$cache/todo") of them new or changed"
find "$cache" -type f -mtime +30 -delete
# shellcheck disable=SC2016  # $1 belongs to the inner shell
xargs -r -d '\n' -n 1 -P "$(nproc)" bash -c 'check_one "$1"' check_one <"$cache/todo"
# Everything passed.
(($# > 0)) || {
    echo "# Batches that passed clang-tidy, written by tools/tidy.sh: the hash of all that a batch depends on, and its name."
    sort -k 2 "$cache/keys" | tr '\t' ' ' | sed "s|$root/build/tidy-ON/||; s|$root/||"
} >"$list"
