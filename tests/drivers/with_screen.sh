#!/usr/bin/env bash
# tests/drivers/with_screen.sh COMMAND...: the command with a screen to open windows on.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
need Xvfb
open_screen 1280x720
"$@"
