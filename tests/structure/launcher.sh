#!/usr/bin/env bash
# tests/structure/launcher.sh SOURCE: tests a copy of ./thaum with fake dpkg-query, apt-get, sudo, cmake and
# ninja, so that nothing is installed or built. Prints each case; exits with 1 if one fails.
# shellcheck disable=SC2016  # the fake tools expand their own variables
set -euo pipefail

source=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
tree=$place/tree
fake=$place/fake
failures=0
as_user=()  # command prefix that runs the launcher as another user; empty: this user

# tool NAME: makes a fake program from the script on standard input.
tool() {
    { echo '#!/bin/bash' && cat; } >"$fake/$1"
    chmod +x "$fake/$1"
}

# A fresh machine. apt-get only notes the packages; cmake and ninja make a program that prints its arguments.
fresh_machine() {
    rm -rf "${place:?}"/*
    mkdir -p "$fake" "$tree/tools"
    cp "$source/thaum" "$tree/"
    cp "$source/tools/packages.txt" "$tree/tools/"
    : >"$place/installed"
    export PLACE=$place
    tool dpkg-query <<<'for p in "${@:4}"; do grep -qx "$p" "$PLACE/installed" && echo -n "$p:installed "; done; exit 1'
    tool apt-get <<'APT'
echo "apt-get $*" >>"$PLACE/calls"
[[ " $* " == *" install "* ]] && printf '%s\n' "$@" >>"$PLACE/installed"
exit 0
APT
    tool sudo <<<'[[ $1 == -n ]] && shift; [[ $1 == true ]] || exec "$@"'
    tool cmake <<'CMAKE'
echo "cmake $*" >>"$PLACE/calls"
mkdir -p "$PLACE/tree/build/release/game"
touch "$PLACE/tree/build/release/build.ninja"
printf '%s\n' "${@#-D}" >"$PLACE/tree/build/release/CMakeCache.txt"
CMAKE
    tool ninja <<'NINJA'
[[ $* != *build.ninja && $* != *" -n "* ]] || exit 0
program=$PLACE/tree/build/release/game/thaum
[[ -f $program ]] && exit
echo "ninja $*" >>"$PLACE/calls"
printf '#!/bin/bash\necho "started: $*"\n' >"$program"
chmod +x "$program"
NINJA
}

# run ARGUMENTS: starts the copy without a terminal. Sets `output` and `code`.
run() {
    code=0
    output=$(PATH=$fake:$PATH timeout 600 "${as_user[@]}" "$tree/thaum" "$@" </dev/null 2>&1) || code=$?
}

# expect NAME CONDITION...: prints whether the condition holds.
expect() {
    if "${@:2}"; then
        echo "ok: $1"
    else
        echo "FAILED: $1"
        printf 'exit code %s, output:\n%s\n' "$code" "$output"
        failures=$((failures + 1))
    fi
}
says() { [[ $output == *"$1"* ]]; }
says_not() { [[ $output != *"$1"* ]]; }
code_is() { ((code == $1)); }
called() { grep -q -e "$1" "$place/calls" 2>/dev/null; }
not_called() { ! called "$1"; }

fresh_machine
run play --demo "two words"
expect "starts the program with the arguments" says "started: play --demo two words"
expect "prints the missing packages" says "missing Debian packages: clang lld cmake"
expect "installs without asking where there is no terminal" called "install --no-install-recommends clang lld cmake"
expect "leaves the test packages out" not_called libgtest-dev
expect "builds the program alone" called "ninja .* thaum$"
expect "leaves the tests out of the build" called "BUILD_TESTING:BOOL=OFF"

rm -f "$place/calls"
run again
expect "starts a second time" says "started: again"
expect "does nothing else then" not_called .
expect "and says nothing else" test "$output" = "started: again"

rm "$tree"/build/.packages-*
echo gone >"$place/installed"
tool apt-get <<<'echo "E: no network"; exit 100'
run
expect "stops when apt-get fails" code_is 2
expect "gives the reason" says "E: no network"
expect "names the next command" says "apt-get install --no-install-recommends clang"

fresh_machine
tool sudo <<<'exit 1'
chmod -R a+rwX "$place"
((EUID != 0)) || as_user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
run
expect "stops without rights" code_is 2
expect "prints the command to run" says "run as root, then start again: apt-get install"
expect "calls no apt-get" not_called apt-get
chmod -R a-w "$tree"
rmdir "$tree/build" 2>/dev/null || rm -rf "$tree/build"
run
expect "stops where it cannot write" code_is 2
expect "and says where" says "cannot write to $tree"
as_user=()
chmod -R u+w "$tree"

fresh_machine
run
expect "builds only what players need" called "ninja -C $tree/build/release -j$(nproc) thaum$"
tools=0
mapfile -t commands < <(sed -n 's/^ *{"\([a-z]*\)", *".*/\1/p' "$source/game/app/dispatch.cpp" |
    grep -vxE 'play|range|doctor|bench')
for command in "${commands[@]}"; do
    rm "$tree/build/release/game/thaum"
    run "$command"
    ! called "-j$(nproc) thaum-tools" && continue
    tools=$((tools + 1))
    rm "$place/calls"
done
expect "and the tools for each command that needs them" test "$tools" == "${#commands[@]}" -a "$tools" != 0

fresh_machine
tool ninja <<<'echo "[1/2] x"; echo "FAILED: a.o"; echo "a.cpp:1: error: no"; exit 1'
run
expect "stops when the build fails" code_is 2
expect "shows the words of the compiler" says "a.cpp:1: error: no"
expect "and not its progress" says_not "[1/2]"

fresh_machine
run
rm "$tree/build/release/game/thaum"
printf '%s\n' "configure 1" "30000 1.o" "10000 2.o" "10000 3.o" >"$tree/tools/build_times.txt"
tool ninja <<'NINJA'
# As the real one: build.ninja comes first, and a plan by that name does not go beyond it.
[[ $* != *build.ninja ]] || exit 0
[[ $* != *" -n "* || $* == *" -f plan.ninja "* ]] || { echo "[1/2] Re-running CMake..."; exit 0; }
for step in 1 2 3; do echo "[$step/3] Building CXX object $step.o"; done
[[ " $* " != *" -n "* ]] || exit 0
printf '#!/bin/bash\necho "started: $*"\n' >"$PLACE/tree/build/release/game/thaum"
chmod +x "$PLACE/tree/build/release/game/thaum"
NINJA
output=$(PATH=$fake:$PATH script -qec "$tree/thaum" /dev/null </dev/null 2>&1) && code=0 || code=$?
expect "says that a long build takes minutes" says "building release (about "
expect "shows a bar on a terminal" says "building [##################            ]  60 %"
expect "which is full at the end" says "building [##############################] 100 %"
expect "and then starts" says "started:"

fresh_machine
echo "flags : sse2 avx" >"$place/cpuinfo"
export THAUM_CPUINFO=$place/cpuinfo
run
expect "builds the portable way on an old processor" called "THAUM_PORTABLE:BOOL=ON"
expect "says which instructions it lacks" says "names no avx2"
expect "starts all the same" says "started:"
echo "flags : avx2 fma bmi1 bmi2 f16c movbe abm" >"$place/cpuinfo"
fresh_machine
echo "flags : avx2 fma bmi1 bmi2 f16c movbe abm" >"$place/cpuinfo"
run
expect "builds for AVX2 where there is one" not_called "THAUM_PORTABLE"
unset THAUM_CPUINFO

fresh_machine
run test --nonsense
expect "refuses an unknown option" code_is 2
run test --help
expect "has help" says "./thaum test [--quick | --long] [FILTER]"
run --help
expect "passes --help on" says "started: --help"

((failures == 0))
