"""Helpers that several steps share."""
import concurrent.futures
import json
import subprocess
import sys
import time
from pathlib import Path

KINDS = ("comparison", "call", "constant")

# The tree that is mutated: the one that holds this tool, unless --source names another.
OWN_TREE = Path(__file__).resolve().parent.parent.parent
SWITCH_HEADER = Path(__file__).resolve().parent / "mutant_switch.h"


def say(text):
    print(f"{Path(sys.argv[0]).stem}: {text}", flush=True)


def stop(text):
    print(f"{Path(sys.argv[0]).stem}: {text}", file=sys.stderr)
    sys.exit(2)


def write_json(path, value):
    """Writes a temporary file and renames it, so that an interrupted step leaves no incomplete file."""
    part = path.with_name(path.name + ".part")
    part.write_text(json.dumps(value, indent=1, ensure_ascii=False) + "\n")
    part.rename(path)


def read_mutants(folder):
    path = folder / "mutants.json"
    if not path.exists():
        stop(f"{path} is missing; run the step draw first")
    return json.loads(path.read_text())


def tracked_files(source):
    listed = subprocess.run(["git", "-C", str(source), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                            check=True, capture_output=True).stdout.decode()
    return sorted({name for name in listed.split("\0") if name and (source / name).is_file()})


def add_assets(build, tree):
    """Links the assets into the folder of a build outside of the tree, so that its programs find them."""
    place = build / "assets"
    if not place.is_symlink():
        place.symlink_to(tree / "assets")


def run_logged(command, log):
    """Runs a command with its output in a file. Returns its exit code and output."""
    with open(log, "wb") as out:
        code = subprocess.run([str(c) for c in command], stdout=out, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL).returncode
    return code, log.read_text(errors="replace")


def with_edits(data, mutants):
    """The bytes of a source with the edits of mutants. The last edit is made first, so that the positions of
    the others stay valid."""
    edits = [(begin, end, text.replace("on(@)", f"on({m['id']})")) for m in mutants for begin, end, text in m["edits"]]
    for begin, end, text in sorted(edits, reverse=True):
        data = data[:begin] + text.encode() + data[end:]
    return data


def in_parallel(runner, jobs, function, items, what):
    """Calls the function for each item, and prints every half minute how many are done."""
    done, last = 0, time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        futures = [pool.submit(function, item) for item in items]
        try:
            for future in concurrent.futures.as_completed(futures):
                future.result()
                done += 1
                if time.monotonic() - last > 30:
                    last = time.monotonic()
                    say(f"{what}: {done} of {len(items)}")
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            runner.stop()
            raise
