# tests/drivers/offscreen.sh: functions for tests of commands without a window; to be sourced after `set -uo pipefail`.

# work_in_new_folder: makes a temporary folder ($folder) the working one and the home of settings and recordings. There
# is no display. $repository is the source tree, which stands two folders above the test.
work_in_new_folder() {
    repository=$(readlink -f "$(dirname "$0")/../..")
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    cd "$folder" || exit 1
    unset DISPLAY WAYLAND_DISPLAY
    export XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data
}

# fail WORDS: prints a fault and counts it in $failures. The test goes on.
failures=0
fail() { echo "failed: $1"; failures=$((failures + 1)); }
