#!/usr/bin/env bash
# tests/drivers/with_screen.sh COMMAND...: runs the command with a virtual screen.
set -euo pipefail
. "$(dirname "$0")/screen.sh"
need Xvfb
open_screen 1280x720
"$@"
