#!/usr/bin/env bash
# tests/drivers/key_labels.sh KEY_PROBE: what prompts call the keys on five keyboard layouts, by setxkbmap under Xvfb. A
# line below is a layout and the labels of the keys that are W, A, S, D, Z, M, Comma and Semicolon on a US keyboard, then of
# 1, Space, F3 and KP_8, which are called so everywhere. Exits with 77 if a tool is missing.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
probe=$1
need Xvfb setxkbmap
open_screen 640x360

while read -r layout labels; do
    # "us,ru" and the like have several layouts, of which the first is active.
    setxkbmap -layout "${layout%:*}" -variant "$([[ $layout != *:* ]] || echo "${layout#*:}")"
    said=$("$probe" W A S D Z M Comma Semicolon 1 Space F3 KP_8 | cut -d ' ' -f 2 | paste -sd ' ')
    [ "$said" = "$labels 1 Space F3 KP_8" ] || failed "$layout: $said instead of $labels 1 Space F3 KP_8"
done <<'TABLE'
us W A S D Z M Comma Semicolon
fr Z Q S D W Comma Semicolon M
de W A S D Y M Comma Ö
us:dvorak Comma A O E Semicolon M W S
ru Ц Ф Ы В Я Ь Б Ж
us,ru W A S D Z M Comma Semicolon
TABLE
[ "$("$probe" Comma | cut -d ' ' -f 3)" = , ] || failed "no sign for a comma"
echo "labels are right on six layouts"
