#!/usr/bin/env bash
# tests/structure/launcher.sh SOURCE: tests a copy of ./thaum with fake dpkg-query, apt-get, sudo, cmake and
# ninja, so that nothing is installed or built. Prints each case; exits with 1 if one fails.
# shellcheck disable=SC2016  # the fake tools expand their own variables
set -euo pipefail
for name in "${!CTEST_@}" "${!GTEST_@}"; do unset "$name"; done  # ctest sets variables that thaum reports

source=$1
place=$(mktemp -d)
trap 'chmod -R u+w "$place" && rm -rf "$place"' EXIT
tree=$place/tree
fake=$place/fake
failures=0
as_user=()  # command prefix that runs the launcher as another user; empty: this user

# tool NAME: makes a fake program from the script on standard input.
tool() {
    { echo '#!/bin/bash' && cat; } >"$fake/$1"
    chmod +x "$fake/$1"
}

# A fresh machine with a tree that has one source and one asset. apt-get only notes the packages. cmake and ninja make a
# program that prints its arguments, the source of the tree for which cmake was called, and the asset that it finds.
fresh_machine() {
    chmod -R u+w "$place"
    rm -rf "${place:?}"/*
    mkdir -p "$fake" "$place/home"
    : >"$place/installed"
    export PLACE=$place HOME=$place/home
    unset XDG_CACHE_HOME THAUM_ASSETS
    as_user=()
    fresh_tree "$place/tree"
    tool dpkg-query <<<'for p in "${@:4}"; do grep -qx "$p" "$PLACE/installed" && echo -n "$p:installed "; done; exit 1'
    tool apt-get <<'APT'
echo "apt-get $* with umask $(umask)" >>"$PLACE/calls"
[[ " $* " == *" install "* ]] && printf '%s\n' "$@" >>"$PLACE/installed"
exit 0
APT
    tool sudo <<<'[[ $1 == -n ]] && shift; [[ $1 == true ]] || exec "$@"'
    # Like the real cmake, it keeps the entries of a cache that belongs here, and refuses the cache of another
    # place.
    tool cmake <<'CMAKE'
echo "cmake $*" >>"$PLACE/calls"
env -0 >>"$PLACE/env"
entries=(CMAKE_CXX_COMPILER:STRING=/usr/bin/clang++)
fresh=false
while (($# > 0)); do
    case $1 in
    -S) source=$2 ;;
    -B) dir=$2 ;;
    -D*) entries+=("${1#-D}") ;;
    --fresh) fresh=true ;;
    esac
    shift
done
[[ $source$dir != *[\"\;\#$'\n']* ]] || { echo "CMake Error: a bad path"; exit 1; }
mkdir -p "$dir/game"
cache=$dir/CMakeCache.txt
$fresh || ! grep -s ^CMAKE_HOME_DIRECTORY: "$cache" | grep -vqxF "CMAKE_HOME_DIRECTORY:INTERNAL=$source" ||
    { echo "CMake Error: another source"; exit 1; }
[[ ! -e $cache ]] || $fresh || grep -q ^CMAKE_GENERATOR:INTERNAL=Ninja "$cache" || { echo "CMake Error: another generator"; exit 1; }
touch "$cache"
echo rules >"$dir/build.ninja"
$fresh || mapfile -t -O "${#entries[@]}" entries < <(grep -v '^CMAKE_' "$cache")
printf '%s\n' "${entries[@]}" "CMAKE_HOME_DIRECTORY:INTERNAL=$source" "CMAKE_CACHEFILE_DIR:INTERNAL=$dir" CMAKE_GENERATOR:INTERNAL=Ninja >"$cache"
CMAKE
    tool ninja <<'NINJA'
[[ -s $2/build.ninja ]] || { echo "ninja: error: no targets"; exit 1; }
[[ $* != *build.ninja && $* != *" -n "* ]] || exit 0
source=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$2/CMakeCache.txt")
program=$2/game/thaum
[[ -f $program && -f $2/.ninja_log && ! $source/engine/code -nt $program ]] && exit
echo "ninja $*" >>"$PLACE/calls"
touch "$2/.ninja_log"
cat >"$program" <<PROGRAM
#!/bin/bash
echo "started: \$*"
echo "code: $(cat "$source/engine/code")" >>"\$PLACE/facts"
echo "asset: \$(cat "\${THAUM_ASSETS:-\${0%/*}/../../../assets}/word")" >>"\$PLACE/facts"
PROGRAM
chmod +x "$program"
NINJA
}

# fresh_tree FOLDER: makes a tree there, which becomes the tree that `run` starts.
fresh_tree() {
    tree=$1
    mkdir -p "$tree"/{tools,engine,game,assets}
    cp "$source"/{thaum,CMakeLists.txt,CMakePresets.json} "$tree/"
    cp "$source/tools/packages.txt" "$tree/tools/"
    echo first >"$tree/engine/code"
    echo usual >"$tree/assets/word"
}

# A machine on which no package is missing.
ready_machine() {
    fresh_machine
    cut -d ' ' -f 2 "$source/tools/packages.txt" >"$place/installed"
}

# other_user: lets the next runs start the launcher as a user who owns nothing here. If this test does not run
# as root, they start it as the same user, who then must not be able to write where it matters.
other_user() {
    chmod -R a+rX "$place"
    chmod a+rwX "$place" "$place"/{calls,facts,env,installed} 2>/dev/null || true
    ((EUID != 0)) || as_user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
}

# run ARGUMENTS: starts the copy without a terminal. Sets `output` and `code`.
run() {
    code=0
    rm -f "$place/facts"
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
not() { ! "$@"; }
code_is() { ((code == $1)); }
called() { grep -q -e "$1" "$place/calls" 2>/dev/null; }
not_called() { ! called "$1"; }
runs() { says "started: $1" && grep -qx "code: $2" "$place/facts" && grep -qx "asset: $3" "$place/facts"; }
# The folder that the launcher makes for the tree in the user's cache folder.
cache_place() { echo "${XDG_CACHE_HOME:-$HOME/.cache}"/thaum/*; }

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

rm -r "$tree/build"
echo gone >"$place/installed"
tool apt-get <<<'echo "E: no network"; exit 100'
run
expect "stops when apt-get fails" code_is 2
expect "gives the reason" says "E: no network"
expect "names the next command" says "apt-get install --no-install-recommends clang"

fresh_machine
tool sudo <<<'exit 1'
other_user
chmod -R a+rwX "$place"
run
expect "stops without rights" code_is 2
expect "prints the command to run" says "run as root, then start again: apt-get install"
expect "calls no apt-get" not_called apt-get
ready_machine
run
expect "builds only what players need" called "ninja -C $tree/build/release -j$(nproc) thaum$"
tools=0
mapfile -t commands < <(sed -n 's/^ *{"\([a-z]*\)", *".*/\1/p' "$source/game/app/dispatch.cpp" |
    grep -vxE 'play|range|check|doctor|bench')
for command in "${commands[@]}"; do
    rm "$tree/build/release/game/thaum" "$place/calls"
    run "$command"
    ! called "-j$(nproc) thaum-tools" || tools=$((tools + 1))
done
expect "and the tools for each command that needs them" test "$tools" == "${#commands[@]}" -a "$tools" != 0

ready_machine
tool ninja <<<'echo "[1/2] x"; echo "FAILED: a.o"; echo "a.cpp:1: error: no"; exit 1'
run
expect "stops when the build fails" code_is 2
expect "shows the words of the compiler" says "a.cpp:1: error: no"
expect "and not its progress" says_not "[1/2]"

ready_machine
run
rm "$tree/build/release/game/thaum"
printf '%s\n' "configure 1" "30000 1.o" "10000 2.o" "10000 3.o" >"$tree/tools/build_times.txt"
tool ninja <<'NINJA'
# Like the real ninja, it brings build.ninja up to date first, and a dry run (-n) of that name goes no
# further.
[[ $* != *build.ninja ]] || exit 0
[[ $* != *" -n "* || $* == *" -f plan.ninja "* ]] || { echo "[1/2] Re-running CMake..."; exit 0; }
for step in 1 2 3; do echo "[$step/3] Building CXX object $step.o"; done
[[ " $* " != *" -n "* ]] || exit 0
printf '#!/bin/bash\necho "started: $*"\n' >"$2/game/thaum"
chmod +x "$2/game/thaum"
NINJA
output=$(TERM=xterm PATH=$fake:$PATH script -qec "$tree/thaum" /dev/null </dev/null 2>&1) && code=0 || code=$?
expect "says that a long build takes minutes" says "building release (about "
expect "shows a bar on a terminal" says "building [##################            ]  60 %"
expect "which is full at the end" says "building [##############################] 100 %"
expect "and then starts" says "started:"

ready_machine
echo "flags : sse2 avx" >"$place/cpuinfo"
export THAUM_CPUINFO=$place/cpuinfo
run
expect "builds the portable way on an old processor" called "THAUM_PORTABLE:BOOL=ON"
expect "says which instructions it lacks" says "names no avx2"
expect "starts all the same" says "started:"
echo "flags : avx2 fma bmi1 bmi2 f16c movbe abm" >"$place/cpuinfo"
ready_machine
echo "flags : avx2 fma bmi1 bmi2 f16c movbe abm" >"$place/cpuinfo"
run
expect "builds for AVX2 where there is one" not_called "THAUM_PORTABLE"
echo "flags : sse2 avx" >"$place/cpuinfo"
run
expect "and anew on an older processor" called "THAUM_PORTABLE:BOOL=ON"
unset THAUM_CPUINFO

ready_machine
run test --nonsense
expect "refuses an unknown option" code_is 2
run test --help
expect "has help" says "./thaum test [--quick | --long] [FILTER]"
run --help
expect "passes --help on" says "started: --help"

# ---- moved, copied, another user's, read-only --------------------------------------------------------------------

ready_machine
run bench
mv "$tree" "$place/moved tree"
tree=$place/moved\ tree
rm "$place/calls"
run
expect "starts in a folder that was moved" runs "" first usual
expect "and makes nothing again" not_called .
printf '%s\n' THAUM_OWN:BOOL=ON >>"$tree/build/release/CMakeCache.txt"
echo second >"$tree/engine/code"
run
expect "builds in a moved folder what changed" runs "" second usual
expect "keeps the entries of the build" grep -q THAUM_OWN "$tree/build/release/CMakeCache.txt"

ready_machine
run
cp -a "$tree" "$place/copy"
tree=$place/copy
rm "$place/calls"
echo copied >"$tree/assets/word"
run
expect "starts a copy with the copy's assets" runs "" first copied
expect "and makes nothing again" not_called .
echo second >"$tree/engine/code"
run
expect "builds the copy's code" runs "" second copied
tree=$place/tree
rm "$place/calls"
run
expect "and leaves the first tree as it is" runs "" first usual
expect "and built" not_called .

ready_machine
run
other_user
chmod -R a-w "$tree"
rm "$place/calls"
run
expect "starts what another user built" runs "" first usual
expect "and nothing is said or made" test "$output" = "started: " -a ! -e "$place/calls"
chmod u+w "$tree/engine/code"
echo second >"$tree/engine/code"
chmod a-w "$tree/engine/code"
run
expect "says where it cannot build" says "and cannot make the folder $HOME/.cache/thaum/tree-"
expect "and stops, if the cache folder cannot be written either" code_is 2
mkdir -p "$HOME/.cache"
chmod a+rwx "$HOME/.cache"
run
expect "builds what changed in the user's cache folder" runs "" second usual
expect "and says so" says "building in $(cache_place), because cannot write to $tree/build"
rm -f "$place/calls"
run
expect "and starts that again" runs "" second usual
expect "without building" test "$output" = "started: " -a ! -e "$place/calls"
export XDG_CACHE_HOME=
unset HOME
run
expect "stops where there is no place for a cache" code_is 2
export HOME=relative
run
expect "also where HOME is relative" says "and there is no HOME for a cache folder"
unset HOME
run
expect "and says what to do" says "set XDG_CACHE_HOME to a folder to build in"
export XDG_CACHE_HOME=$place/other
mkdir -m 777 "$XDG_CACHE_HOME"
run
expect "builds where XDG_CACHE_HOME says" test -x "$(cache_place)/build/release/game/thaum"

# An archive that is unpacked over the tree brings other sources with old times, which ninja does not see, so
# everything is built again. The same holds after a build while the clock was ahead.
ready_machine
run
echo archive >"$tree/engine/code"
touch -d '20 years ago' "$tree/engine/code"
run
expect "makes what an archive brought with an old time" runs "" archive usual
rm -f "$place/calls"
run
expect "once" test ! -e "$place/calls"
touch -d '10 years' "$tree/build/release/"{.began,.built-thaum,game/thaum}
echo later >"$tree/engine/code"
run
expect "makes what changed, too, after a build by a clock that was ahead" runs "" later usual

# A build older than the packages is built again by a user who may, and is good enough for others if no
# package is missing.
ready_machine
find "$tree" -path "$tree/build" -prune -o -exec touch -d '20 years ago' {} +
run
touch -d '10 years ago' "$tree/build/release/.built-thaum"
touch -d '20 years ago' "$tree/build/release/CMakeCache.txt"
other_user
chmod -R a-w "$tree"
run
expect "starts what another user built with older packages" runs "" first usual
expect "as it is" test "$output" = "started: "

for other in other 'with space'; do
    ready_machine
    fresh_tree "$place/$other/tree"
    tree=$place/tree
    chmod -R a-w "$place/tree" "$place/$other/tree"
    other_user
    mkdir "$HOME/.cache"
    chmod a+rwx "$HOME/.cache"
    export XDG_CACHE_HOME=relative  # a relative path does not count
    run
    expect "builds a read-only tree that was never built" runs "" first usual
    tree=$place/$other/tree
    run
    places=("$HOME"/.cache/thaum/*)
    expect "and another one of that name elsewhere" test "${#places[@]}" = 2
done

# A first start without rights leaves a build folder, and a second one as root fills it.
if ((EUID == 0)); then
    ready_machine
    run
    echo second >"$tree/engine/code"
    other_user
    chmod a+rwx "$HOME" "$tree/build"
    run
    expect "builds elsewhere if only a part of the build folder can be written" runs "" second usual
fi

# Root can write everywhere except on a read-only file system.
if ((EUID == 0)) && unshare -m true 2>/dev/null; then
    ready_machine
    # shellcheck disable=SC2016
    as_user=(unshare -m bash -c 'mount --bind "$0" "$0" && mount -o remount,bind,ro "$0" && exec "$@"' "$tree")
    run
    expect "builds a tree on a read-only file system" runs "" first usual
fi

# ---- disks --------------------------------------------------------------------------------------------------------

ready_machine
tool df <<<'printf "%s\n" "Size Avail" "1000 5"'
run
expect "stops before a build that cannot fit on the disk" code_is 2
expect "and says so" says "no space left on $tree/build (5 MB free, about 170 MB needed)"
expect "and makes nothing" not_called .
rm "$fake/df"
run
tool df <<<'printf "%s\n" "Size Avail" "1000 5"'
echo second >"$tree/engine/code"
run
expect "builds a change on a nearly full disk" runs "" second usual
tool df <<<'printf "%s\n" "Size Avail" "0 0"'
rm -rf "$tree/build"
run
expect "builds where the file system does not know how much is free" runs "" second usual

ready_machine
tool ninja <<<'echo "LLVM ERROR: IO failure on output stream: No space left on device"; exit 1'
run
expect "says that the disk was full" says "no space left on $tree/build ("
expect "in the last line" test "$(grep -c 'no space' <<<"${output##*$'\n'}")" = 1
ready_machine
as_user=(bash -c 'ulimit -f 100; exec "$@"' --)
tool ninja <<<'exit 1'
run
expect "names other limits where the disk is not full" says "no file of 1 MB can be made in"

# own_disk OPTIONS: gives the build folder a disk of its own in the next runs.
own_disk() {
    mkdir -p "$tree/build"
    # shellcheck disable=SC2016
    as_user=(unshare -m bash -c 'mount -t tmpfs -o "$0" none "$1/build" && shift && exec "$@"' "$1" "$tree")
}
if ((EUID == 0)) && unshare -m true 2>/dev/null; then
    ready_machine
    tool df <<<'exit 1'
    tool ninja <<<'head -c 9000000 /dev/zero >"$2/a" 2>/dev/null || exit 1'
    own_disk size=1200k
    run
    expect "finds a full disk by itself where no program names it" says "no space left on $tree/build ("

    ready_machine
    own_disk noexec
    run
    expect "builds elsewhere if programs in the build folder may not be started" runs "" first usual
    expect "and says so" says "because programs in $tree/build may not be started (its disk is mounted with noexec)"
fi

# ---- surroundings -------------------------------------------------------------------------------------------------

fresh_machine
cat >"$place/start_file" <<'START'
cmake() { echo "a function of the caller's"; }
readlink() { echo nowhere; }
START
umask 077
flags=-ffast-math
as_user=(env CXXFLAGS="$flags" CFLAGS="$flags" CPPFLAGS="$flags" LDFLAGS="$flags" CC=tcc CXX=tcc CPATH=/x CPLUS_INCLUDE_PATH=/x
    MAKEFLAGS=-j99 NINJA_STATUS=x CMAKE_PREFIX_PATH=/x CMAKE_TOOLCHAIN_FILE=/x PKG_CONFIG_PATH=/x CCC_OVERRIDE_OPTIONS=+-m32
    CDPATH=/usr:/ GREP_OPTIONS=-v POSIXLY_CORRECT=1 BASH_ENV="$place/start_file" SHELLOPTS=noclobber:noglob BASHOPTS=nullglob
    TMPDIR="$place/gone" LANG=xx_XX LC_ALL=xx_XX GLOBIGNORE='*' 'BASH_FUNC_flock%%=() { exit 7; }')
run
umask 022
expect "starts in odd surroundings" runs "" first usual
expect "says what it does not use" says "must not depend on it: CC CXX CFLAGS CXXFLAGS CPPFLAGS LDFLAGS MAKEFLAGS NINJA_STATUS CPATH"
expect "and what else" says "CMAKE_PREFIX_PATH CMAKE_TOOLCHAIN_FILE PKG_CONFIG_PATH TMPDIR"
expect "builds without them" not grep -qzE '^(C|CXX|CPP|LD|MAKE)FLAGS=|^CC=|^CXX=|PATH=/x|/gone|_FILE=/x|m32' "$place/env"
expect "installs packages for all users" called "install .* with umask 0022"
run
expect "says nothing of it where nothing is built" says_not "must not depend"

for name in 'a b' "it's" $'\u00fc' $'two\nlines' $'an end\n' -dash 'say "so"' 'a;b' 'a#b' 'a$b' 'a*b' 'a[b' 'a\b'; do
    ready_machine
    fresh_tree "$place/$name"
    run
    expect "starts in a folder called $(printf %q "$name")" runs "" first usual
done

ready_machine
mkdir "$place/elsewhere"
ln -s ../tree/thaum "$place/elsewhere/link"
for start in ./link 'bash link' 'sh link' "bash $place/tree/thaum" 'bash --posix link'; do
    rm -rf "$tree/build"
    # shellcheck disable=SC2086  # two words
    output=$(cd "$place/elsewhere" && PATH=$fake:$PATH timeout 600 $start --demo "two words" 2>&1 </dev/null) || true
    expect "starts by $start" says "started: --demo two words"
done

# A machine without some of its usual programs.
# without NAME...: starts the launcher with a PATH that lacks these programs.
without() {
    local name
    mkdir "$place/bin"
    ln -s /usr/bin/* "$place/bin"
    for name in "$@"; do rm -f "$place/bin/$name" "$fake/$name"; done
    as_user=(env PATH="$fake:$place/bin")
}
ready_machine
without flock
run
expect "starts without flock" runs "" first usual
expect "and says that it takes no turns" says "no program 'flock' (package util-linux)"
expect "once" test "$(grep -c flock <<<"$output")" = 1
for name in cmp ninja; do
    ready_machine
    without "$name"
    run
    expect "stops where there is no $name" code_is 2
    expect "and names it" test "${output##*$'\n'}" = "thaum: there is no program '$name' in the folders of PATH, which are $fake:$place/bin"
done

ready_machine
run
printf '%s\n' '#!/bin/bash' env >"$tree/build/release/game/thaum"
as_user=(env -u PATH)
run
expect "gives programs a PATH where none was set" grep -q "^PATH=/" <<<"$output"

ready_machine
as_user=(env LD_PRELOAD=/gone.so)
run
expect "takes the words of a loader for no fault" runs "" first usual
expect "and builds in the tree" test -x "$tree/build/release/game/thaum"

ready_machine
run
: >"$tree/build/release/build.ninja"  # empty, as after a loss of power
echo second >"$tree/engine/code"
run
expect "configures anew where nothing is in build.ninja" runs "" second usual
sed -i '/^CMAKE_GENERATOR/d' "$tree/build/release/CMakeCache.txt"
rm "$tree/build/release/.configured"
echo third >"$tree/engine/code"
run
expect "and after another generator" runs "" third usual

ready_machine
tool cmake <<<'echo "a fault of a kind that nobody foresaw"; exit 1'
run
expect "shows the end of a log that names no error" says "a fault of a kind that nobody foresaw"

ready_machine
mkdir "$place/alone"
cp "$tree/thaum" "$place/alone/"
tree=$place/alone
run
expect "stops where the launcher was copied alone" code_is 2
expect "and says what to do instead" says "no CMakeLists.txt in $place/alone, so the game's folder is not complete; to start"
expect "in one line" test "$(wc -l <<<"$output")" = 1

ready_machine
fresh_tree "$place/"$'red\e(0'
: >"$tree/build"
run
expect "builds elsewhere where 'build' is a file" runs "" first usual
expect "and says so" says "cannot make the folder $place/red?(0/build: File exists"
expect "without a control character of a folder's name" says_not $'\e'

# Streams that are closed or full, and a working folder that is gone.
for streams in '<&-' '>&-' '2>&-' '<&- >&- 2>&-' '>/dev/full' '2>/dev/full'; do
    ready_machine
    as_user=(bash -c "exec \"\$@\" $streams" --)
    run
    expect "starts with $streams" grep -qsx "code: first" "$place/facts"
done
ready_machine
mkdir "$place/gone"
mv "$fake/cmake" "$fake/real-cmake"
tool cmake <<<'/bin/pwd >/dev/null || exit 1; exec "${0%/*}/real-cmake" "$@"'
# shellcheck disable=SC2016
as_user=(bash -c 'cd "$0" && rmdir "$0" && exec "$@"' "$place/gone")
run
expect "builds from a working folder that is gone" runs "" first usual

# Two users' languages may sort names differently, which is no reason to build again.
ready_machine
tool sort <<<'language=${LC_ALL:-${LANG:-}}; [[ $language != de* ]] || set -- -r "$@"; exec /usr/bin/sort "$@"'
export LANG=de_DE.UTF-8
run
export LANG=C
rm -f "$place/calls"
run
expect "has built for users of all languages" test "$output" = "started: " -a ! -e "$place/calls"
unset LANG

ready_machine
mv "$fake/ninja" "$fake/real-ninja"
tool ninja <<'NINJA'
"${0%/*}/real-ninja" "$@"
[[ $* != *build.ninja && $* != *" -n "* ]] || exit 0
printf '[1/3] Building CXX object a.o\n'
NINJA
output=$(TERM=dumb PATH=$fake:$PATH script -qec "$tree/thaum" /dev/null </dev/null 2>&1) && code=0 || code=$?
expect "sends no commands to a terminal that has none" says_not $'\e'
expect "and starts there" says "started:"

# ---- two at once -----------------------------------------------------------------------------------------------------

# Each fake tool reports if another one runs at the same time. The first apt-get waits until the second start
# of the launcher waits for it.
fresh_machine
for name in apt-get cmake ninja; do
    mv "$fake/$name" "$fake/real-$name"
    tool "$name" <<'TURN'
mkdir "$PLACE/busy" || echo "two at once" >>"$PLACE/calls"
for ((i = 0; i < 1200 && !$(cat "$PLACE"/start-* | grep -c waiting); ++i)); do sleep 0.1; done
echo "(waiting is over)" >>"$PLACE/start-1"
"${0%/*}/real-${0##*/}" "$@"
result=$?
rmdir "$PLACE/busy"
exit $result
TURN
done
PATH=$fake:$PATH "$tree/thaum" one >"$place/start-1" 2>&1 </dev/null &
PATH=$fake:$PATH "$tree/thaum" two >"$place/start-2" 2>&1 </dev/null &
wait
output=$(cat "$place"/start-*) code=
expect "two starts at once both start" test "$(grep -c '^started: ' <<<"$output")" = 2
expect "they take turns" not_called "two at once"
expect "and build once" test "$(grep -c '^ninja' "$place/calls")" = 1
expect "and install once" test "$(grep -c '^apt-get.* install ' "$place/calls")" = 1

# Another start runs from its first to its last step while this one tries whether programs may be started there. Then a
# file of another start is gone before its rights can be asked for, as between find's look at a folder and at a file.
ready_machine
tool chmod <<'CHMOD'
PATH=${PATH#*:} chmod "$@"
[[ $1 == 700 ]] && mkdir "$PLACE/nested" 2>/dev/null && "$PLACE/tree/thaum" within >"$PLACE/start-within" 2>&1
exit 0
CHMOD
run
expect "is not confused by another start" says "started:"
expect "which starts, too" grep -q '^started: within' "$place/start-within"
expect "both in the tree" says_not "building in"
tool find <<'FIND'
PATH=${PATH#*:} find "$@"
[[ $* != *writable* ]] || printf '%s\0' "$1/.gone"
FIND
run
expect "nor by a file that is gone" says_not "building in"

ready_machine
mv "$fake/cmake" "$fake/real-cmake"
tool cmake <<<'kill -9 $PPID'
run
expect "a start is killed" code_is 137
mv "$fake/real-cmake" "$fake/cmake"
run
expect "and the next one builds" runs "" first usual

# Ctrl-C reaches all programs of the terminal. ninja ends by itself then.
ready_machine
mv "$fake/ninja" "$fake/real-ninja"
tool ninja <<'NINJA'
[[ $* != *build.ninja && $* != *" -n "* ]] || exec "${0%/*}/real-ninja" "$@"
trap 'echo "[1/9] Building CXX object a.o"; echo "ninja: build stopped: interrupted by user."; exit 2' INT
kill -INT 0
sleep 1
NINJA
as_user=(setsid -w)
run
expect "is interrupted by Ctrl-C" code_is 130
expect "and says so and nothing else" test "$(grep -v 'not used' <<<"$output")" = "thaum: interrupted; start again to go on"
mv "$fake/real-ninja" "$fake/ninja"
run
expect "and goes on at the next start" runs "" first usual

# A first build that was killed has made a program of the first source. Then another source with an old time takes its place.
ready_machine
mv "$fake/ninja" "$fake/real-ninja"
tool ninja <<<'"${0%/*}/real-ninja" "$@"; [[ $* == *build.ninja || $* == *" -n "* ]] || kill -9 $PPID'
run
expect "a build is killed" test "$code" != 0 -a -e "$tree/build/release/game/thaum"
mv "$fake/real-ninja" "$fake/ninja"
echo archive >"$tree/engine/code"
touch -d '20 years ago' "$tree/engine/code"
run
expect "and the next one sees what an archive brought meanwhile" runs "" archive usual

((failures == 0))
