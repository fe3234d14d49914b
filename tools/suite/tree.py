"""Steps apply and build: a copy of the tree with every mutant in it, and its build."""
import collections
import hashlib
import re
import shutil
import time
from pathlib import Path

from common import SWITCH_HEADER, add_assets, read_mutants, run_logged, say, stop, tracked_files, with_edits, write_json

INCLUDED = "tools/suite/mutant_switch.h"  # place of the switch header in the copied tree
INCLUDE = ('add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-include${CMAKE_CURRENT_SOURCE_DIR}/' + INCLUDED + '>")\n')
MOST_ROUNDS = 20
# Files that later steps write about a build.
RESULTS = ("reach.jsonl", "results*.tsv")


def apply(options):
    folder, source = options.out, options.source
    drawn = read_mutants(folder)
    tree = folder / "tree"
    if tree.exists():
        shutil.rmtree(tree)
    for name in tracked_files(source):
        place = tree / name
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source / name, place, follow_symlinks=False)
    (tree / INCLUDED).parent.mkdir(parents=True, exist_ok=True)
    shutil.copy2(SWITCH_HEADER, tree / INCLUDED)
    include_everywhere(tree / "CMakeLists.txt")
    for name, mutants in by_file(drawn["mutants"]).items():
        mutate(tree / name, mutants)
    for mutant in drawn["mutants"]:
        mutant.pop("withdrawn", None)
    write_json(folder / "mutants.json", drawn)
    forget_results(folder)
    say(f"{len(drawn['mutants'])} mutants are in {tree}")


def include_everywhere(cmake):
    """Makes every target include the switch. The line is in the tree's own file, so that copies of the tree
    that tests make have it, too."""
    text, count = re.subn(r"^(project\([^)]*\)[^\n]*\n)", lambda m: m.group(1) + INCLUDE, cmake.read_text(), count=1,
                          flags=re.M)
    if count != 1:
        stop(f"{cmake} has no project()")
    cmake.write_text(text)


def by_file(mutants):
    files = collections.defaultdict(list)
    for mutant in mutants:
        files[mutant["file"]].append(mutant)
    return files


def mutate(path, mutants):
    data = path.read_bytes()
    if any(m["sha256"] != hashlib.sha256(data).hexdigest() for m in mutants):
        stop(f"{path.name} changed since the mutants were drawn; draw again")
    path.write_bytes(with_edits(data, mutants))


def forget_results(folder):
    for pattern in RESULTS:
        for path in folder.glob(pattern):
            path.unlink()


# ---- build ---------------------------------------------------------------------------------------------------

def build(options):
    folder = options.out
    tree, place = folder / "tree", folder / "build"
    if not tree.exists():
        stop(f"{tree} is missing; run the step apply first")
    begin = time.monotonic()
    code, output = run_logged(
        ["cmake", "-S", tree, "-B", place, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
         f"-DCMAKE_CXX_FLAGS_RELEASE={options.flags}", "-DBUILD_TESTING=ON", "-DTHAUM_PORTABLE=ON",
         "-DTHAUM_WARNINGS_AS_ERRORS=OFF"], folder / "configure.log")
    if code != 0:
        stop(f"cmake failed: {output[-2000:]}")
    targets = options.targets.split(",") if options.targets else []
    for _ in range(MOST_ROUNDS):
        code, output = run_logged(["ninja", "-C", place, f"-j{options.jobs}", "-k0", *targets], folder / "build.log")
        if code == 0:
            add_assets(place, tree)
            say(f"built in {time.monotonic() - begin:.0f} s")
            return
        if not withdraw_failed(options, output):
            stop(f"the build failed, and not because of a mutant; see {folder / 'build.log'}")
    stop("the build still fails")


def withdraw_failed(options, output):
    """Restores the sources whose mutants do not compile. Returns how many sources that were."""
    folder = options.out
    drawn = read_mutants(folder)
    live = {name for name, mutants in by_file(drawn["mutants"]).items() if "withdrawn" not in mutants[0]}
    failed = files_of_errors(output, folder / "tree", live)
    for name in sorted(failed):
        shutil.copy2(options.source / name, folder / "tree" / name)
        (folder / "tree" / name).touch()
        for mutant in drawn["mutants"]:
            if mutant["file"] == name:
                mutant["withdrawn"] = True
        say(f"{name} does not compile with its mutants; they are withdrawn: {failed[name]}")
    write_json(folder / "mutants.json", drawn)
    return len(failed)


def files_of_errors(output, tree, live):
    """The mutated sources in which the compiler found errors, each with the first error. If an error stands elsewhere,
    in a header say, all mutated sources that its message names are taken."""
    failed = {}
    for part in output.split("\nFAILED: ")[1:]:
        errors = re.findall(r"^(\S+?):\d+:\d+: (?:fatal )?error: (.*)$", part, re.M)
        inside = [(name_in(tree, path), text) for path, text in errors]
        found = {name: text for name, text in reversed(inside) if name in live}
        if not found and errors:
            named = {name_in(tree, path) for path in re.findall(r"(/\S+?\.cpp)\b", part)} & live
            found = {name: errors[0][1] for name in named}
        failed.update(found)
    return failed


def name_in(tree, path):
    try:
        return str(Path(path).resolve().relative_to(tree.resolve()))
    except ValueError:
        return ""
