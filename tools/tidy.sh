#!/usr/bin/env bash
# tools/tidy.sh BUILD: clang-tidy over every source of ours in BUILD/compile_commands.json.
#
# clang-tidy is slow, so a source that passed is remembered under a key. The key is a hash of everything the
# source depends on: the settings, the compiler's command, and the text of the source and of every header of
# ours that it includes (known to ninja).
set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
build=$(readlink -f "$1")
cache=$root/build/tidy
mkdir -p "$cache"

# Prints lines "SOURCE TAB FILE": each file of ours that a source's object was made from, the source included.
dependencies() {
    ninja -C "$build" -t deps | awk -v root="$root/" -v build="$build/" '
        /^[^ ]/ { source = ""; next }
        NF == 0 { next }
        {
            sub(/^ +/, "")
            # A compiler cache may have made paths relative to the build folder, which is two levels below the
            # root.
            if (!sub(/^\.\.\/\.\.\//, root) && $0 !~ /^\//) $0 = build $0
            if (source == "") source = $0
            if (index($0, root) == 1 && index(source, root) == 1) print source "\t" $0
        }'
}

# Prints lines "KEY TAB SOURCE".
keys() {
    local common
    common=$({ clang-tidy --version && cat "$root/.clang-tidy" && grep -h '"command"' "$build/compile_commands.json" |
        sed 's/.*"command": "\(.*\) -o .*/\1/' | sort -u; } | sha256sum | cut -c1-16)
    dependencies | sort -u >"$cache/dependencies"
    # One hash per file, then per source a hash of its hashes. Objects of deleted sources may still be in the
    # build folder.
    cut -f2 "$cache/dependencies" | sort -u | while IFS= read -r file; do
        if [[ -f $file ]]; then printf '%s\n' "$file"; fi
    done |
        xargs -r -d '\n' sha256sum >"$cache/hashes"
    awk -F '\t' -v common="$common" '
        NR == FNR { hash[substr($0, 67)] = substr($0, 1, 64); next }
        { all[$1] = all[$1] hash[$2] }
        END { for (source in all) print common all[source] "\t" source }' "$cache/hashes" "$cache/dependencies" |
        while IFS=$'\t' read -r text source; do
            printf '%s\t%s\n' "$(printf '%s' "$text$source" | sha256sum | cut -c1-40)" "$source"
        done
}

check_one() {
    local key=${1%%$'\t'*} source=${1#*$'\t'} output
    if output=$(clang-tidy --quiet -p "$build" --extra-arg=-Wno-error --extra-arg=-Wno-unknown-warning-option \
        --extra-arg=-Wno-unknown-pragmas "$source" 2>&1); then
        : >"$cache/$key"
    else
        printf '%s\n' "$output" | grep -v -e 'warnings generated' -e '^Suppressed' -e '^Use -header-filter'
        return 1
    fi
}
export -f check_one
export root build cache

keys >"$cache/keys"
while IFS=$'\t' read -r key source; do
    if [[ -e $cache/$key ]]; then touch "$cache/$key"; else printf '%s\t%s\n' "$key" "$source"; fi
done <"$cache/keys" >"$cache/todo"
echo "clang-tidy: $(wc -l <"$cache/keys") sources, $(wc -l <"$cache/todo") of them new or changed"
find "$cache" -type f -mtime +30 -delete
# shellcheck disable=SC2016  # $1 belongs to the inner shell
xargs -r -d '\n' -n 1 -P "$(nproc)" bash -c 'check_one "$1"' check_one <"$cache/todo"
