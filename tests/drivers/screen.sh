# tests/drivers/screen.sh, sourced: what the tests with a window share. Needs `set -euo pipefail`.

# need TOOL...: leaves with 77 (skipped) where one is missing.
need() {
    local tool
    for tool in "$@"; do
        command -v "$tool" >/dev/null || { echo "skipped: no $tool"; exit 77; }
    done
}

# open_screen SIZE: a folder that goes at the end ($folder), and an X server without a screen of glass ($DISPLAY).
open_screen() {
    folder=$(mktemp -d)
    Xvfb -displayfd 3 -noreset -screen 0 "$1x24" 3>"$folder/display" 2>/dev/null &
    screen_server=$!
    trap 'kill "$screen_server"; rm -rf "$folder"' EXIT
    for _ in $(seq 100); do
        [ -s "$folder/display" ] && break
        sleep 0.05
    done
    DISPLAY=:$(cat "$folder/display")
    # Under the address sanitizer: X and OpenGL libraries leave a few blocks when they are unloaded, and umockdev wants
    # to be loaded first. Leaks of our own are looked for in the tests without a window.
    export ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0
    export DISPLAY XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data
}
