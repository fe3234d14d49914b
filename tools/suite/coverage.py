"""Chooses the cases that run under sanitizers, and how many inputs fuzzing tries, by the code that each reaches. See
COVERAGE.md."""
import argparse
import array
import collections
import concurrent.futures
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

from cases import FAILED, PASSED, SKIPPED, Runner, as_list, reach_each, read_cases, read_reach
from common import OWN_TREE, add_assets, run_logged, say, stop

LIST = OWN_TREE / "tests" / "left_out_under_sanitizers.txt"
LIST_HEAD = """\
# Cases that the sanitizers' build leaves out, because cheaper cases reach the code that they reach. Written by
# tools/suite/coverage.sh; a case that is not named here runs.
"""
# Cases that always run, whatever code they reach, because they test inputs and hostile values: the latter, if they are cheap.
ALWAYS = re.compile(r"^fuzz\.")
HOSTILE = re.compile("Hostile|Wild")
MOST_HOSTILE_COST = 2.5  # processor time (s)
PARAMETER = "  # GetParam() = "
FUZZ_LIST = OWN_TREE / "tests" / "fuzz_runs.txt"
FUZZ_HEAD = """\
# Readers of files and protocols that are fuzzed, and how many inputs each gets in `./thaum test`: so many that more would
# reach hardly any new code. Written by tools/suite/coverage.sh; a new reader is added by hand, with any number.
"""
FUZZ_RUNS = (100, 200, 400, 800, 1600)
ENOUGH_BLOCKS = 0.995  # share of the blocks that the most inputs reach
ENOUGH_PLACES = 0.998  # share of the places of all cases that the chosen ones reach
MOST_FUZZ_COST = 10  # processor time after which a reader gets no more inputs (s)
LEAST_COST = 0.05  # processor time that starting a case takes at least (s)
MAGIC_64_BIT = 0xC0BFFFFFFFFFFF64
BATCH = 20_000  # addresses that one call of the symbolizer gets


# ---- build ---------------------------------------------------------------------------------------------------

def build(options):
    """The sanitizers' build, which also notes which basic blocks of the program ran."""
    place = options.out / "build"
    flags = "-fsanitize-coverage=bb,trace-pc-guard"
    code, output = run_logged(
        ["cmake", "-S", OWN_TREE, "--preset", "asan+ubsan", "-B", place, "-DBUILD_TESTING=ON", f"-DCMAKE_C_FLAGS={flags}",
         f"-DCMAKE_CXX_FLAGS={flags}"], options.out / "configure.log")
    if code != 0:
        stop(f"cmake failed: {output[-2000:]}")
    code, output = run_logged(["ninja", "-C", place, f"-j{options.jobs}"], options.out / "build.log")
    if code != 0:
        stop(f"the build failed: {output[-2000:]}")
    add_assets(place, OWN_TREE)


# ---- reach ---------------------------------------------------------------------------------------------------

def reach(options):
    """Runs every case once. Its blocks go into reached/N.json; what is known already is not run again."""
    folder = options.out
    (folder / "reached").mkdir(exist_ok=True)
    cases, known = read_cases(folder, options.cases), read_reach(folder)
    todo = [case for name, case in cases.items()
            if name not in known and "slow" not in as_list(case.properties.get("LABELS"))]
    runner = Runner(folder, limited=False)
    reach_each(folder, todo, runner, options.jobs, lambda case: reach_one(runner, folder, case))
    for name, entry in sorted(read_reach(folder).items()):
        if entry["verdict"] == FAILED:
            say(f"fails, and is not judged ({entry['how']}): {name}")


def reach_one(runner, folder, case):
    place = folder / "tmp" / f"reached-{threading.get_ident()}"
    place.mkdir()
    place.chmod(0o777)  # some cases run a program as another user
    times = place / "times"
    # The sanitizer writes its messages into files, because some cases check the output of programs.
    outcome = runner.run(case, case.limit, {
        "ASAN_OPTIONS": f"intercept_tls_get_addr=0:coverage=1:coverage_dir={place}:log_path={place}/log",
        "UBSAN_OPTIONS": "print_stacktrace=1",
        "THAUM_CASE_TIMES": str(times)})
    spent, blocks = spent_time(times), blocks_in(place)
    shutil.rmtree(place)
    known = {program: sorted(addresses) for program, addresses in blocks.items()}
    (folder / "reached" / f"{file_name_of(case.name)}.json").write_text(json.dumps(known))
    return {"case": case.name, "verdict": outcome.verdict, "how": outcome.how, "cost": spent or outcome.seconds}


def file_name_of(case):
    return re.sub(r"[^A-Za-z0-9_.-]", "_", case)


def spent_time(times):
    """The processor time that tests/timed.sh wrote into a file (s)."""
    return sum(int(line.split("\t")[0]) for line in times.read_text().splitlines()) / 1000 if times.exists() else 0


def blocks_in(place):
    """The addresses of the blocks that ran, by program, from the files that the processes left."""
    blocks = collections.defaultdict(set)
    for file in place.glob("*.sancov"):
        blocks[file.name.split(".")[0]].update(read_addresses(file))
    return blocks


def read_addresses(path):
    words = array.array("Q")
    data = path.read_bytes()
    words.frombytes(data[:len(data) // 8 * 8])
    if not words or words[0] != MAGIC_64_BIT:
        return []  # the file of a process that was killed while it wrote
    return words[1:]


# ---- choose --------------------------------------------------------------------------------------------------

def choose(options):
    """Writes the list of cases that are left out, because the other cases reach almost all of their code."""
    folder = options.out
    entries = read_reach(folder)
    known = {name: entry for name, entry in entries.items() if entry["verdict"] == PASSED}
    skipped = {name for name, entry in entries.items() if entry["verdict"] == SKIPPED}
    reached = places_reached(folder, known)
    cost = {name: max(entry["cost"], LEAST_COST) for name, entry in known.items()}
    chosen = cover(reached, cost, {name for name in known if runs_always(name, cost[name])})
    left_out = sorted((set(known) - chosen) | skipped)
    # Names of some cases end with the bytes of a parameter, which may be addresses and differ in every run.
    options.list.write_text(LIST_HEAD + "".join(f"{name.partition(PARAMETER)[0]}\n" for name in left_out))
    every = set().union(*reached.values())
    still = set().union(*(reached[name] for name in chosen))
    say(f"{len(chosen)} of {len(known)} cases reach {len(still)} of {len(every)} places of engine and game; they take "
        f"{sum(cost[name] for name in chosen):.0f} of {sum(cost.values()):.0f} s of a processor")
    if len(still) < ENOUGH_PLACES * len(every):
        stop("the chosen cases do not reach enough")


def runs_always(name, cost):
    return ALWAYS.match(name) or (HOSTILE.search(name) and cost < MOST_HOSTILE_COST)


def places_reached(folder, known):
    """For each case the places in our sources that it reaches. Places are numbered from 0."""
    addresses = collections.defaultdict(set)
    files = {name: folder / "reached" / f"{file_name_of(name)}.json" for name in known}
    for path in files.values():
        for program, blocks in json.loads(path.read_text()).items():
            addresses[program].update(blocks)
    numbers, places = {}, {}
    for program, blocks in sorted(addresses.items()):
        found = [path for path in (folder / "build").rglob(program) if path.is_file() and os.access(path, os.X_OK)]
        if not found:
            continue  # a program that a case built itself
        begin = time.monotonic()
        places[program] = {address: numbers.setdefault(place, len(numbers))
                           for address, place in symbolized(found[0], sorted(blocks)) if place}
        say(f"{program}: {len(places[program])} of {len(blocks)} blocks are ours ({time.monotonic() - begin:.0f} s)")
    result = {}
    for name, path in files.items():
        result[name] = {places[program][block] for program, blocks in json.loads(path.read_text()).items()
                        if program in places for block in blocks if block in places[program]}
    return result


def symbolized(program, addresses):
    """Yields each address with its place in engine/ or game/ ("file:line:column"), or nothing. A block of an inlined
    function belongs to that function."""
    parts = [addresses[i:i + BATCH] for i in range(0, len(addresses), BATCH)]
    with concurrent.futures.ThreadPoolExecutor(max(os.cpu_count() or 1, 1)) as pool:
        for part, lines in zip(parts, pool.map(lambda some: symbolize(program, some), parts)):
            for address, line in zip(part, lines):
                name = line.removeprefix(f"{OWN_TREE}/")
                yield address, name if name.startswith(("engine/", "game/")) else ""


def symbolize(program, addresses):
    symbolizer = shutil.which("llvm-symbolizer") or shutil.which("llvm-symbolizer-14") or stop("no llvm-symbolizer")
    text = "".join(f"{hex(a)}\n" for a in addresses)
    shown = subprocess.run([symbolizer, f"--obj={program}", "--functions=none", "--no-inlines"], input=text,
                           capture_output=True, text=True, check=True).stdout
    return [block.strip() for block in shown.strip().split("\n\n")]


def cover(reached, cost, always):
    """A cheap set of cases that reaches enough places. First adds, again and again, the case with the most
    new places per second. Then removes cases that the others have made unnecessary, the dearest first."""
    every = set().union(*reached.values())
    chosen, lacking = set(always), every - set().union(*(reached[name] for name in always))
    gain = {name: len(places & lacking) for name, places in reached.items()}
    while len(lacking) > (1 - ENOUGH_PLACES) * len(every):
        while True:
            name = max(gain, key=lambda name: gain[name] / cost[name])
            now = len(reached[name] & lacking)
            if now == gain[name]:
                break
            gain[name] = now  # the gain of a case only falls, so the others need not be counted again
        chosen.add(name)
        lacking -= reached[name]
        gain[name] = 0
    times = collections.Counter(place for name in chosen for place in reached[name])
    for name in sorted(chosen - always, key=lambda name: -cost[name]):
        if all(times[place] > 1 for place in reached[name]):
            chosen.remove(name)
            times.subtract(reached[name])
    return chosen


# ---- fuzz ----------------------------------------------------------------------------------------------------

def fuzz(options):
    """Writes how many inputs each reader gets."""
    readers = [line.split()[0] for line in FUZZ_LIST.read_text().splitlines() if line and not line.startswith("#")]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        counts = list(pool.map(lambda reader: runs_of(options.out, reader), readers))
    FUZZ_LIST.write_text(FUZZ_HEAD + "".join(f"{reader} {runs}\n" for reader, runs in zip(readers, counts)))


def runs_of(folder, reader):
    """The fewest inputs that reach nearly all blocks that the most inputs reach."""
    blocks = {}
    for runs in FUZZ_RUNS:
        blocks[runs], cost = blocks_of_fuzzing(folder, reader, runs)
        if cost > MOST_FUZZ_COST:
            break
    most = max(blocks.values())
    fewest = next(runs for runs, count in blocks.items() if count >= ENOUGH_BLOCKS * most)
    say(f"{reader}: {fewest} inputs; blocks: {', '.join(f'{runs}: {count}' for runs, count in blocks.items())}")
    return fewest


def blocks_of_fuzzing(folder, reader, runs):
    """How many blocks so many inputs reach, and the processor time that they took (s)."""
    place = folder / "tmp" / f"fuzz-{reader}"
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    times = place / "times"
    result = subprocess.run(
        [OWN_TREE / "tests/timed.sh", folder / "build/tests/thaum_fuzz", reader, "--runs", str(runs)], cwd=place,
        capture_output=True, env={**os.environ, "ASAN_OPTIONS": f"coverage=1:coverage_dir={place}",
                                  "THAUM_CASE_TIMES": str(times)}, check=False)
    if result.returncode != 0:
        stop(f"{reader}: {result.stdout.decode(errors='replace')}{result.stderr.decode(errors='replace')}")
    cost, blocks = spent_time(times), blocks_in(place)
    shutil.rmtree(place)
    return sum(map(len, blocks.values())), cost


def main():
    parser = argparse.ArgumentParser(prog="coverage.sh", description=__doc__)
    parser.add_argument("step", choices=("build", "reach", "choose", "fuzz", "all"))
    parser.add_argument("--out", type=lambda text: Path(text).resolve(), required=True, help="folder of the measurement")
    parser.add_argument("--cases", default="", help="file with names of cases, one a line; only these are run")
    parser.add_argument("--list", type=Path, default=LIST, help="file that the step choose writes")
    parser.add_argument("-j", "--jobs", type=int, default=max(os.cpu_count() or 1, 1))
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    for step in (build, reach, choose, fuzz):
        if options.step in (step.__name__, "all"):
            step(options)


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        main()
    except KeyboardInterrupt:
        print("coverage: stopped; the same step goes on from here", file=sys.stderr)
        sys.exit(130)
