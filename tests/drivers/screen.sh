# tests/drivers/screen.sh, sourced: what the tests with a window share. Needs `set -euo pipefail`.

# need TOOL...: leaves with 77 (skipped) where one is missing.
need() {
    local tool
    for tool in "$@"; do
        command -v "$tool" >/dev/null || { echo "skipped: no $tool"; exit 77; }
    done
}

# failed WORDS: the test's last word. A test may define at_failure, which shows more.
failed() {
    echo "failed: $1"
    ! declare -F at_failure >/dev/null || at_failure
    exit 1
}

# eventually WORDS COMMAND...: waits until the command succeeds. The limit only ends a test that hangs: on a busy machine a thing
# takes as long as it takes, so no test may count seconds instead of looking for the event.
eventually() {
    local what=$1 until=$((SECONDS + 300))
    shift
    while ((SECONDS < until)); do
        "$@" && return
        sleep 0.05
    done
    failed "$what"
}

# open_screen SIZE: a folder that goes at the end ($folder), and an X server without a screen of glass ($DISPLAY).
open_screen() {
    folder=$(mktemp -d)
    Xvfb -displayfd 3 -noreset -screen 0 "$1x24" 3>"$folder/display" 2>/dev/null &
    screen_server=$!
    trap 'kill "$screen_server"; rm -rf "$folder"' EXIT
    eventually "no X server" [ -s "$folder/display" ]
    DISPLAY=:$(cat "$folder/display")
    # Under the address sanitizer: X and OpenGL libraries leave a few blocks when they are unloaded, and umockdev wants
    # to be loaded first. Leaks of our own are looked for in the tests without a window.
    export ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0
    export DISPLAY XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data
}
