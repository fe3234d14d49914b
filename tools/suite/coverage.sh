#!/usr/bin/env bash
# tools/suite/coverage.sh STEP OPTION...: chooses the cases that run under sanitizers, by the code that each reaches.
# COVERAGE.md says how; --help lists steps and options.
set -euo pipefail
PYTHONDONTWRITEBYTECODE=1 exec /usr/bin/python3 "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/coverage.py" "$@"
