# tests/drivers/screen.sh: functions for tests with a window; to be sourced after `set -euo pipefail`.

# need TOOL...: exits with 77 (skipped) if a tool is missing.
need() {
    local tool
    for tool in "$@"; do
        command -v "$tool" >/dev/null || { echo "skipped: no $tool"; exit 77; }
    done
}

# failed WORDS: prints the reason and ends the test. A test may define at_failure to show more.
failed() {
    echo "failed: $1"
    ! declare -F at_failure >/dev/null || at_failure
    exit 1
}

# eventually WORDS COMMAND...: waits until the command succeeds. The limit only ends a test that hangs. A busy
# machine may take any time, so tests must wait for events and not count seconds.
eventually() {
    local what=$1 until=$((SECONDS + 900))
    shift
    while ((SECONDS < until)); do
        "$@" && return
        sleep 0.2
    done
    failed "$what"
}

# open_screen SIZE: makes a temporary folder ($folder) and a virtual X server ($DISPLAY).
open_screen() {
    folder=$(mktemp -d)
    Xvfb -displayfd 3 -noreset -screen 0 "$1x24" 3>"$folder/display" 2>/dev/null &
    screen_server=$!
    trap 'kill "$screen_server"; rm -rf "$folder"' EXIT
    eventually "no X server" [ -s "$folder/display" ]
    DISPLAY=:$(cat "$folder/display")
    # Every machine has OpenAL's silent sound device; a test of sound takes another.
    export ALSOFT_DRIVERS=null
    # Address sanitizer: X and OpenGL libraries leak a few blocks when they are unloaded, and umockdev must be
    # loaded before it. The tests without a window look for leaks of our own.
    export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0:verify_asan_link_order=0
    export DISPLAY XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data
}

# presses KEY...: presses and releases keys, one after the other, by the program $press_keys.
presses() { "$press_keys" "$@"; }

# live NAME FIELD TYPE: a field of FakeHdLive, which a fake arm keeps in $folder/NAME.live: 0 to 2 the force, 3 the
# largest force, 4 ticks, 5 whether a program has the arm, 6 to 8 the force at its closing. TYPE is f8 or u8.
live() { od -An -v -t"$3" -j$((8 * $2)) -N8 "$folder/$1.live" 2>/dev/null | tr -d ' '; }

# colours AREA, pixels AREA, mean AREA: what the screen shows in an area, WIDTHxHEIGHT+X+Y: the number of colours, each pixel,
# or the mean colour (look_at.cpp). picture NAME: keeps a picture of the whole screen if $SHOTS names a folder.
colours() { "$LOOK_AT" colours "$1" 2>/dev/null || echo 0; }
pixels() { "$LOOK_AT" pixels "$1" 2>/dev/null; }
mean() { "$LOOK_AT" mean "$1" 2>/dev/null; }
picture() { [ -z "${SHOTS:-}" ] || import -window root "$SHOTS/$1.png"; }

# few_pictures: settings for tests that need few pictures, of any quality. Drawing without a graphics card would take
# every core.
few_pictures() {
    mkdir -p "$XDG_CONFIG_HOME/thaum"
    printf '%s\n' 'version = 1' 'quality = "low"' 'frames_per_second = 10' 'countdown_s = 0' >"$XDG_CONFIG_HOME/thaum/settings.toml"
}

# title: the window's title, which names the menu's page and its chosen row: "Thaum (paused): Settings / Split: top and
# bottom". on_row ROW: tests whether the row with this label is chosen.
title() { "$LOOK_AT" title 2>/dev/null || true; }
on_row() {
    local now
    now=$(title)
    [[ $now == *": "* ]] || return
    now=${now#*: }
    now=${now#* / }
    [[ $now == "$1" || $now == "$1: "* ]]
}
menu_open() { [[ $(title) == *": "* ]]; }

# moves_on KEY...: presses keys, each once the one before has had its effect on the menu's page or row.
moves_on() {
    local key before until
    for key in "$@"; do
        before=$(title)
        until=$((SECONDS + 900))
        presses "$key"
        while [ "$(title)" = "$before" ]; do
            ((SECONDS < until)) || failed "the key $key has no effect on '$before'"
            sleep 0.02
        done
    done
}

# choose ROW [KEY]: moves to the row with this label, by the key Down or another one, wherever the row is.
choose() {
    local until=$((SECONDS + 900))
    until on_row "$1"; do
        ((SECONDS < until)) || failed "no row '$1' near '$(title)'"
        moves_on "${2:-Down}"
    done
}

# paused, no_pause_menu: test, by the window's title, whether keys go to the pause menu, or to the match.
paused() { [[ $(title) == "Thaum (paused): "* ]]; }
no_pause_menu() { [ "$(title)" = Thaum ]; }

# pause_menu: tests whether the match is paused and the menu shows a chosen row, at whatever height: most of a row of 27 lines
# in its colour. The row alone could be one of the start screen, which stays until the match is drawn.
pause_menu() {
    paused &&
        [ "$(pixels 80x720+900+0 | grep -c '#5[0-9A-F]3[0-9A-F][89][0-9A-F]')" -gt 1600 ]
}
