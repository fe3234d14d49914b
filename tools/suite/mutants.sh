#!/usr/bin/env bash
# tools/suite/mutants.sh STEP OPTION...: measures how many small faults of the program its tests find. MUTANTS.md says
# how; --help lists steps and options. Installs its packages (group "mutants" of tools/packages.txt) if they are missing.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
python=/usr/bin/python3  # the Python for which Debian makes the packages

install_packages() {
    local -a packages as_root=()
    mapfile -t packages < <(awk '$1 == "mutants" { print $2 }' "$here/../packages.txt")
    dpkg -s "${packages[@]}" >/dev/null 2>&1 && return 0
    ((EUID == 0)) || as_root=(sudo)
    echo "mutants: installing ${packages[*]}" >&2
    "${as_root[@]}" apt-get install -q -y --no-install-recommends "${packages[@]}" >&2 || {
        "${as_root[@]}" apt-get update -q >&2
        "${as_root[@]}" apt-get install -q -y --no-install-recommends "${packages[@]}" >&2
    }
}

case ${1-} in draw | all) install_packages ;; esac
PYTHONDONTWRITEBYTECODE=1 exec "$python" "$here/mutants.py" "$@"
