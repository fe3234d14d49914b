"""Step draw: chooses the mutants. The result depends on the seed and the sources alone."""
import collections
import hashlib
import json
import multiprocessing
import random
import signal
import time

from common import KINDS, run_logged, say, stop, tracked_files, write_json

# Sources that are not mutated: code that runs before main or before the check of the processor, and examples,
# which are no part of the engine.
LEFT_OUT = ("game/app/start_check.cpp", "engine/core/processor.cpp", "engine/physics/bullet_maths.cpp",
            "engine/examples/")


def draw(options):
    folder, source = options.out, options.source
    folder.mkdir(parents=True, exist_ok=True)
    commands = compile_commands(source, folder)
    only = tuple(options.only.split(",")) if options.only else ("engine/", "game/")
    names = [n for n in tracked_files(source) if n.endswith(".cpp") and n.startswith(("engine/", "game/")) and
             n.startswith(only) and not n.startswith(LEFT_OUT) and str(source / n) in commands]
    if not names:
        stop("no source to mutate")
    mutants = draw_from(source, names, commands, options)
    write_json(folder / "mutants.json", {"seed": options.seed, "source": str(source), "mutants": mutants})
    count = collections.Counter(m["kind"] for m in mutants)
    say(f"{len(mutants)} mutants in {len({m['file'] for m in mutants})} files: " +
        ", ".join(f"{count[kind]} {kind}" for kind in KINDS))


def compile_commands(source, folder):
    """Configures a build without unity sources; nothing is compiled."""
    code, output = run_logged(
        ["cmake", "-S", source, "-B", folder / "db", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
         "-DCMAKE_UNITY_BUILD=OFF", "-DBUILD_TESTING=ON", "-DTHAUM_PORTABLE=ON", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"],
        folder / "db.log")
    if code != 0:
        stop(f"cmake failed: {output[-2000:]}")
    entries = json.loads((folder / "db" / "compile_commands.json").read_text())
    # A source that is compiled several times is read as it is compiled first.
    return {entry["file"]: entry["command"] for entry in reversed(entries)}


def draw_from(source, names, commands, options):
    """Draws files with chances in proportion to their lines, one file for every three mutants, and in each a
    mutant of each kind. If files have too few mutants, further files are drawn."""
    lines = {name: (source / name).read_bytes().count(b"\n") for name in names}
    chance = random.Random(f"files {options.seed}")
    wanted, drawn = collections.Counter(), {}
    while (missing := options.count - sum(len(found) for found in drawn.values())) > 0:
        left = [n for n in names if lines[n] > 0 and len(drawn.get(n, [])) >= wanted[n]]
        if not left:
            break
        slots = -(-missing // len(KINDS))
        added = chance.choices(left, [lines[n] for n in left], k=slots)
        wanted.update({name: len(KINDS) * times for name, times in collections.Counter(added).items()})
        drawn |= draw_in_files([(source, name, commands[str(source / name)], wanted[name], options.seed)
                                for name in sorted(set(added))], options.jobs)
    return number(drawn, options)


def draw_in_files(todo, jobs):
    drawn, last = {}, time.monotonic()
    # libclang keeps much memory, so a process reads four files and ends.
    with multiprocessing.Pool(jobs, initializer=end_quietly, maxtasksperchild=4) as pool:
        for name, found, fault in pool.imap_unordered(draw_in_file, todo):
            if fault:
                say(f"{name} is left out: {fault}")
            drawn[name] = found
            if time.monotonic() - last > 30:
                last = time.monotonic()
                say(f"draw: {len(drawn)} of {len(todo)} files")
    return drawn


def end_quietly():
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def number(drawn, options):
    mutants = [m for name in sorted(drawn) for m in drawn[name]]
    if len(mutants) > options.count:  # the last file brought one or two too many
        mutants = random.Random(f"rest {options.seed}").sample(mutants, options.count)
    mutants.sort(key=lambda m: (m["file"], m["line"], m["column"], m["kind"]))
    for i, mutant in enumerate(mutants):
        mutant["id"] = i + 1
    return mutants


def draw_in_file(job):
    from candidates import Source  # libclang is loaded in the step that needs it only
    source, name, command, count, seed = job
    parsed = Source(source / name, command)
    if parsed.faults:
        return name, [], parsed.faults[0]
    chance = random.Random(f"{name} {seed}")
    found = parsed.candidates()
    chance.shuffle(found)
    digest = hashlib.sha256(parsed.bytes).hexdigest()
    chosen = []
    # Takes one mutant of each kind in turn. A kind without further candidates is skipped.
    queues = {kind: [c for c in found if c["kind"] == kind] for kind in KINDS}
    turn = chance.randrange(len(KINDS))
    while len(chosen) < count and any(queues.values()):
        queue = queues[KINDS[turn % len(KINDS)]]
        turn += 1
        while queue:
            candidate = queue.pop()
            other = candidate.pop("other", None)
            if other and chance.random() < 0.5:
                candidate = other
            if not overlaps(candidate, chosen) and parsed.compiles_with(candidate["edits"]):
                chosen.append(candidate | {"file": name, "sha256": digest})
                break
    return name, chosen, ""


def overlaps(candidate, chosen):
    """Whether the candidate's edits overlap those of a chosen mutant, or begin at the same place."""
    for mutant in chosen:
        for begin, end, _ in mutant["edits"]:
            for b, e, _ in candidate["edits"]:
                if (begin < e and b < end) or begin == b:
                    return True
    return False
