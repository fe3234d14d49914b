#!/usr/bin/env bash
# tests/install/package.sh SOURCE BUILD COMPILER: installs a build into an empty folder and uses it as a stranger
# would. All examples are built with find_package, one with pkg-config, and must print what those of BUILD print.
set -euo pipefail

source=$1
build=$2
compiler=$3
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
log=$source/tests/replays/$(cd "$source/tests/replays" && printf '%s\n' *.thaumlog | sort -V | tail -n 1)

stop() {
    echo "FAILED: $*"
    exit 1
}

# run_examples PROGRAMS RESULTS: starts every example, and keeps what each prints and writes.
run_examples() {
    local programs=$1 results=$2 name
    mkdir -p "$results"
    for name in entities felt_sphere balanced_forces; do
        "$programs/example_$name" >"$results/$name" 2>&1 ||
            stop "$name ends with an error: $(tail -n 1 "$results/$name")"
    done
    "$programs/example_stirred_bowl" "$results/bowl.nrrd" >"$results/stirred_bowl" || stop "the bowl was not written"
    "$programs/example_log_to_csv" "$log" >"$results/log.csv" 2>"$results/log_to_csv" || stop "$log was not read"
}

# Fails unless two folders hold the same files with the same bytes.
expect_same() {
    diff -r "$1" "$2" >"$place/difference" || stop "$3 prints something else: $(head -n 5 "$place/difference")"
    echo "ok: $3 prints the same"
}

# ---- install, and move the folder: no path in it may be absolute ------------------------------------------------

cmake --install "$build" --prefix "$place/first" >"$place/install.log" || stop "cmake --install fails"
mv "$place/first" "$place/prefix"
prefix=$place/prefix
! grep -rlF -e "$source" -e "$place/first" "$prefix/lib" --include='*.cmake' --include='*.pc' ||
    stop "the package names a folder of the build"

# ---- the examples ----------------------------------------------------------------------------------------------

run_examples "$build/engine/examples" "$place/in_tree"
[[ $(grep -lE '^hash [0-9a-f]{16}$' "$place"/in_tree/* | wc -l) == 5 ]] || stop "an example prints no hash"
(($(wc -l <"$place/in_tree/felt_sphere") > 3000)) || stop "the sphere's table is too short"
(($(wc -c <"$place/in_tree/bowl.nrrd") > 4 * 32 * 32 * 32)) || stop "the bowl's file is too short"

cp -r "$source/engine/examples" "$place/examples"
cp -r "$source/tests/install" "$place/probe"
for project in examples probe; do
    cmake -S "$place/$project" -B "$place/build-$project" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
        -DCMAKE_CXX_COMPILER="$compiler" >"$place/configure.log" 2>&1 || stop "$(cat "$place/configure.log")"
    ninja -C "$place/build-$project" >"$place/build.log" || stop "$(tail -n 30 "$place/build.log")"
done
run_examples "$place/build-examples" "$place/by_cmake"
expect_same "$place/in_tree" "$place/by_cmake" "find_package: every example"

"$build/tests/install_probe" "$place/in_tree.png" >"$place/in_tree.probe"
"$place/build-probe/install_probe" "$place/by_cmake.png" >"$place/by_cmake.probe"
expect_same "$place/in_tree.probe" "$place/by_cmake.probe" "find_package: the physics and the sound"
expect_same "$place/in_tree.png" "$place/by_cmake.png" "find_package: the picture"

# ---- pkg-config ------------------------------------------------------------------------------------------------

PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name thaum.pc)")
export PKG_CONFIG_PATH
mkdir "$place/by_pkg_config"
# shellcheck disable=SC2046  # pkg-config prints several words
"$compiler" -O2 "$source/engine/examples/stirred_bowl.cpp" $(pkg-config --cflags --libs thaum) -o "$place/bowl"
"$place/bowl" "$place/by_pkg_config.nrrd" >"$place/by_pkg_config.txt"
expect_same "$place/in_tree/bowl.nrrd" "$place/by_pkg_config.nrrd" "pkg-config: the bowl"
# shellcheck disable=SC2046
"$compiler" -O2 "$source/tests/install/probe.cpp" $(pkg-config --cflags --libs thaum-render thaum-audio thaum-pads) -o "$place/falling"
"$place/falling" >"$place/falling.txt"
expect_same "$place/in_tree.probe" "$place/falling.txt" "pkg-config: the physics and the sound"

# ---- the program -----------------------------------------------------------------------------------------------

cd "$place"
unset THAUM_ASSETS
"$prefix/bin/thaum" replay "$log" --verify >"$place/replay.txt" || stop "the program does not replay $log"
"$prefix/bin/thaum" scenario bolt_kill >"$place/scenario.txt" || stop "the program does not find its scenarios"
"$prefix/bin/thaum" bench --help >"$place/bench.txt" || stop "the program does not find its benchmarks"
echo "ok: the program finds its assets, scenarios and benchmarks"
