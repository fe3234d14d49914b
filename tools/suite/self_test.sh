#!/usr/bin/env bash
# tools/suite/self_test.sh: runs the whole tool on a tiny project in which it is known what the tests find.
# Takes half a minute if nothing else runs. Prints each check; exits with 1 if one fails.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
tree=$place/project
out=$place/out
failures=0

# ---- the project -----------------------------------------------------------------------------------------------

mkdir -p "$tree/engine" "$tree/game"
cat >"$tree/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(Tiny LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
add_library(tiny STATIC engine/tiny.cpp engine/refused.cpp)
add_executable(tests game/tests.cpp)
target_link_libraries(tests PRIVATE tiny)
include(CTest)
foreach(case compares refuses points counts keeps slow)
    add_test(NAME ${case} COMMAND tests ${case})
endforeach()
add_test(NAME broken COMMAND tests broken)
add_test(NAME fails_as_it_must COMMAND tests fails)
set_tests_properties(fails_as_it_must PROPERTIES WILL_FAIL ON)
add_test(NAME skipped COMMAND tests skipped)
set_tests_properties(skipped PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME prints COMMAND tests prints)
set_tests_properties(prints PROPERTIES PASS_REGULAR_EXPRESSION "it is [0-9]+")
add_test(NAME environment COMMAND tests environment)
set_tests_properties(environment PROPERTIES ENVIRONMENT "TINY=yes")
CMAKE
cat >"$tree/engine/tiny.h" <<'CPP'
bool is_seven(int x);
int at_pointer();
int count_down();
int unseen(int x);
int never(int x);
int kept();
CPP
cat >"$tree/engine/tiny.cpp" <<'CPP'
#include "tiny.h"
#include <array>
#define TWICE(x) ((x) < 100 ? (x) * 2 : 200)
namespace {
constexpr int limit = 12;
static_assert(limit > 3);
int value = 3;
int* pointer = nullptr;
void point() { pointer = &value; }
void step(volatile unsigned& i) { i = i - 1; }
void note() { value = value + 0; }
constexpr int doubled(int x) { return x + 2; }
template <int N> int size_of() { return std::array<char, N>().size(); }
}  // namespace
bool is_seven(int x) { return x == unseen(0) + TWICE(3); }  // found
int at_pointer() {
    point();  // crashes
    return *pointer;
}
int count_down() {
    volatile unsigned i = 9;
    while (i) {
        step(i);  // hangs
    }
    if (value) note();  // survives
    else return limit;
    return size_of<4>();
}
int unseen(int x) {
    const int size = 1;  // a constant: dropped at the draw
    char bytes[size] = {};
    static int table[] = {5, 6, 7};
    switch (x) {
        case 0: return bytes[x] + 1;  // found
        default: return table[x];
    }
}
int never(int x) { return x < doubled(x); }  // not reached
CPP
# The compiler refuses what libclang takes, so the mutants of this file are withdrawn.
cat >"$tree/engine/refused.cpp" <<'CPP'
#include "tiny.h"
#ifndef __clang__
#define thaum_mutants nothing
#endif
int kept() { int x = 0; return x + 4; }
CPP
cat >"$tree/game/tests.cpp" <<'CPP'
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include "../engine/tiny.h"
int main(int, char** arguments) {
    const std::string_view name = arguments[1];
    if (name == "compares") return !is_seven(7);
    if (name == "refuses") return is_seven(8);
    if (name == "points") return at_pointer() - 3;
    if (name == "counts") return count_down() - 4;
    if (name == "keeps") return kept() - 4;
    if (name == "slow") for (volatile int i = 0; i < 100000000; i = i + 1) {}
    if (name == "skipped") return 77;
    if (name == "prints") return std::printf("it is %d\n", 5);
    if (name == "environment") return std::getenv("TINY") == nullptr;
    return name == "fails" || name == "broken";
}
CPP
git -C "$tree" init -q

# ---- checks ----------------------------------------------------------------------------------------------------

step() { "$here/mutants.sh" "$@" --out "$out" >>"$place/log" 2>&1 || { cat "$place/log" && exit 1; }; }

# expect WHAT COMMAND...: prints whether COMMAND succeeds; WHAT says what is expected.
expect() {
    local what=$1
    shift
    if "$@"; then echo "ok: $what"; else echo "FAILED: $what" && failures=$((failures + 1)); fi
}

line_of() { grep -n -m1 -F "$1" "$tree/engine/tiny.cpp" | cut -d: -f1; }

# result KIND FILE LINE RESULT [FOUND BY]: tests whether the table has a mutant of that kind at that line of
# the file, with that result.
result() {
    awk -F '\t' -v kind="$1" -v file="engine/$2" -v line="$3" -v result="$4" -v by="${5-}" '
        $2 == kind && $3 == file && $4 == line && $9 == result && index($10, by) == 1 { found = 1 }
        END { exit !found }' "$out/results.tsv"
}
no_mutant() { ! grep -q -x "engine/tiny.cpp $(line_of "$1")" "$place/drawn"; }
says() { grep -q -F "$1" "$place/log"; }

step draw --source "$tree" --seed 3 --count 500 --only engine/ -j1
cp "$out/mutants.json" "$place/first.json"
step draw --source "$tree" --seed 3 --count 500 --only engine/ -j2
/usr/bin/python3 -c 'import json, sys
for m in json.load(sys.stdin)["mutants"]: print(m["file"], m["line"])' <"$out/mutants.json" >"$place/drawn"
expect "the draw repeats" cmp -s "$out/mutants.json" "$place/first.json"
expect "a constant is no mutant" no_mutant "constexpr int limit"
expect "a constant function is no mutant" no_mutant "constexpr int doubled"
expect "a static assertion is no mutant" no_mutant "static_assert"
expect "a static table is no mutant" no_mutant "static int table"
expect "a size of an array is no mutant" no_mutant "const int size"
expect "a macro is no mutant" no_mutant "#define TWICE"

step apply --source "$tree"
step build --source "$tree" -j1
expect "mutants that do not compile are withdrawn" says "engine/refused.cpp does not compile"

step reach -j2
expect "a case that fails without a mutant is left out" says "fails without a mutant (exit code 1): broken"
expect "only that one fails" says "9 cases pass, 1 are skipped, 1 fail"

step run --patience 1 -j2
expect "a comparison is found" result comparison tiny.cpp "$(line_of "// found")" found
expect "a constant is found" result constant tiny.cpp "$(line_of "case 0:")" found
expect "a crash is found" result call tiny.cpp "$(line_of "// crashes")" found "points (signal 11)"
expect "an endless loop is found" result call tiny.cpp "$(line_of "// hangs")" found "counts (time limit)"
expect "a dropped call without effect survives" result call tiny.cpp "$(line_of "// survives")" survived
expect "an unused function is not reached" result comparison tiny.cpp "$(line_of "// not reached")" "not reached"
expect "a withdrawn mutant is not tried" test -z "$(grep refused "$out/results.tsv" || true)"

cp "$out/results.tsv" "$place/whole.tsv"
sed -i 3,5d "$out/results.tsv"
printf '99\thalf a li' >>"$out/results.tsv"
step run --patience 1 -j1
expect "an interrupted run goes on" cmp -s "$out/results.tsv" "$place/whole.tsv"

printf '%s\n' compares refuses counts >"$place/weak"
step run --patience 1 --cases "$place/weak" --results weak.tsv -j2
loses() { ! "$here/mutants.sh" compare "$out/results.tsv" "$out/weak.tsv" >"$place/lost"; }
expect "a weaker suite loses mutants" loses
expect "the lost mutants are named" grep -q "lost (not reached): engine/tiny.cpp:$(line_of "// crashes"): point()" "$place/lost"
expect "a suite loses none to itself" "$here/mutants.sh" compare "$out/results.tsv" "$out/results.tsv"
step run --patience 1 --all-cases --results every.tsv -j2
expect "every case that finds a mutant is named" grep -q "compares (exit code 1); refuses\|refuses (exit code 1); compares" "$out/every.tsv"

expect "lines of mutants were read" grep -q -x "engine/tiny.cpp $(line_of "// crashes")" "$place/drawn"

((failures == 0)) || { cat "$place/log" "$out"/*.tsv && exit 1; }
