"""Steps reach, run and compare: which cases reach which mutants, and which mutants they find."""
import collections
import csv
import threading
import time

from cases import FAILED, PASSED, SKIPPED, TIME_LIMIT, Runner, reach_each, read_cases, read_reach
from common import KINDS, in_parallel, read_mutants, say, stop

COLUMNS = ("id", "kind", "file", "line", "column", "before", "after", "reached by", "result", "found by")
FOUND, SURVIVED, UNDECIDED, NOT_REACHED = "found", "survived", "undecided", "not reached"
# Fields hold neither tabs nor ends of lines, so they need no quotes.
FORMAT = {"delimiter": "\t", "lineterminator": "\n", "quoting": csv.QUOTE_NONE, "quotechar": None}
LIMIT_FACTOR = 10
MOST_TRIES = 4


# ---- reach ---------------------------------------------------------------------------------------------------

def reach(options):
    """Runs every case once without a mutant. What is known already is not run again."""
    folder = options.out
    count = len(read_mutants(folder)["mutants"])
    cases, known = read_cases(folder, options.cases), read_reach(folder)
    todo = [case for name, case in cases.items() if name not in known]
    todo.sort(key=lambda case: (-float(case.properties.get("COST", 0)), case.name))
    runner, begin = Runner(folder), time.monotonic()
    reach_each(folder, todo, runner, options.jobs, lambda case: reach_one(runner, folder, case, count))
    known = {name: entry for name, entry in read_reach(folder).items() if name in cases}
    say(f"{len(todo)} cases in {time.monotonic() - begin:.0f} s")
    report_reach(known, count)


def reach_one(runner, folder, case, count):
    place = folder / "tmp" / f"reached-{threading.get_ident()}"
    place.write_bytes(bytes(count + 1))
    outcome = runner.run(case, case.limit, {"THAUM_MUTANT": "0", "THAUM_MUTANTS_REACHED": str(place)})
    data = place.read_bytes()
    place.unlink()
    return {"case": case.name, "verdict": outcome.verdict, "how": outcome.how, "seconds": round(outcome.seconds, 3),
            "mutants": [i for i in range(1, count + 1) if data[i]]}


def report_reach(known, count):
    for name, entry in sorted(known.items()):
        if entry["verdict"] == FAILED:
            say(f"left out, fails without a mutant ({entry['how']}): {name}")
    verdicts = collections.Counter(entry["verdict"] for entry in known.values())
    reached = {i for entry in known.values() if entry["verdict"] == PASSED for i in entry["mutants"]}
    say(f"{verdicts[PASSED]} cases pass, {verdicts[SKIPPED]} are skipped, {verdicts[FAILED]} fail; "
        f"{len(reached)} of {count} mutants are reached")
    total = sum(entry["seconds"] for entry in known.values())
    most = sum(entry["seconds"] * len(entry["mutants"]) for entry in known.values() if entry["verdict"] == PASSED)
    say(f"the cases take {total:.0f} s one after another; all cases that reach each mutant take {most:.0f} s")


# ---- run -----------------------------------------------------------------------------------------------------

def run(options):
    folder = options.out
    mutants = [m for m in read_mutants(folder)["mutants"] if not m.get("withdrawn")]
    cases, known = read_cases(folder, options.cases), read_reach(folder)
    if not known:
        stop("nothing is known about the cases; run the step reach first")
    plan = plan_of(cases, known)
    results = folder / options.results
    done = {row["id"] for row in read_results(results)} if results.exists() else set()
    todo = [m for m in mutants if str(m["id"]) not in done]
    runner, guard, begin = Runner(folder), threading.Lock(), time.monotonic()
    begin_table(results)
    with open(results, "a", newline="") as out:
        table = csv.writer(out, **FORMAT)

        def one(mutant):
            row = try_mutant(runner, mutant, plan.get(mutant["id"], []), options)
            with guard:
                table.writerow(row)
                out.flush()
        in_parallel(runner, options.jobs, one, todo, "run")
    sort_table(results)
    say(f"{len(todo)} mutants in {time.monotonic() - begin:.0f} s")
    report_results(read_results(results))


def plan_of(cases, known):
    """For each mutant the cases that reach it, the cheapest first."""
    plan = collections.defaultdict(list)
    for name, case in cases.items():
        entry = known.get(name)
        if entry and entry["verdict"] == PASSED:
            for mutant in entry["mutants"]:
                plan[mutant].append((entry["seconds"], name, case))
    for choice in plan.values():
        choice.sort(key=lambda c: c[:2])
    return plan


def try_mutant(runner, mutant, choice, options):
    finders, spent, result = [], 0.0, SURVIVED
    for usual, name, case in choice:
        spent += usual
        if options.budget and spent > options.budget:
            result = UNDECIDED
            break
        how = finds(runner, case, usual, mutant["id"], options.patience)
        if how:
            finders.append(f"{name} ({how})")
            if not options.all_cases:
                break
    if finders or not choice:
        result = FOUND if finders else NOT_REACHED
    return [*(mutant[c] for c in COLUMNS[:7]), len(choice), result, "; ".join(finders)]


def finds(runner, case, usual, mutant, patience):
    """Returns how the case fails with the mutant, or nothing. A mutant that lets a case run for ten times its time is
    found. A failure must happen twice, and a case that runs out of time must be quick without the mutant: a busy machine
    makes cases fail, too."""
    limit = LIMIT_FACTOR * usual + patience
    on, off = {"THAUM_MUTANT": str(mutant)}, {"THAUM_MUTANT": "0"}
    for _ in range(MOST_TRIES):
        outcome = runner.run(case, limit, on)
        if outcome.verdict == FAILED and outcome.how != TIME_LIMIT:
            outcome = runner.run(case, limit, on)
        if outcome.verdict != FAILED or outcome.how != TIME_LIMIT:
            break
        if runner.run(case, limit, off).seconds < limit / 2:
            break
        limit *= 2
    return outcome.how if outcome.verdict == FAILED else ""


def begin_table(path):
    if not path.exists():
        path.write_text("\t".join(COLUMNS) + "\n")
    elif not path.read_text().endswith("\n"):  # half a line of an interrupted step
        path.write_text(path.read_text().rpartition("\n")[0] + "\n")


def read_results(path):
    """Rows of a table. Half a line, left by an interrupted step, is no row."""
    text = path.read_text()
    lines = text[:text.rfind("\n") + 1].splitlines()
    return list(csv.DictReader(lines, **FORMAT))


def sort_table(path):
    rows = sorted(read_results(path), key=lambda row: int(row["id"]))
    part = path.with_name(path.name + ".part")
    with open(part, "w", newline="") as out:
        table = csv.DictWriter(out, COLUMNS, **FORMAT)
        table.writeheader()
        table.writerows(rows)
    part.rename(path)


def report_results(rows):
    for kind in (*KINDS, "all"):
        count = collections.Counter(row["result"] for row in rows if kind in (row["kind"], "all"))
        total = sum(count.values())
        reached = total - count[NOT_REACHED]
        if total:
            undecided = f", {count[UNDECIDED]} undecided" if count[UNDECIDED] else ""
            say(f"{kind}: {count[FOUND]} of {total} found ({100 * count[FOUND] / total:.0f} %), {count[SURVIVED]} "
                f"survived{undecided}, {count[NOT_REACHED]} not reached; of those reached "
                f"{100 * count[FOUND] / max(reached, 1):.0f} % are found")
    for row in rows:
        if row["result"] != FOUND:
            say(f"{row['result']}: {row['id']} {row['file']}:{row['line']}: {row['before']} -> {row['after'] or 'dropped'}")


# ---- compare -------------------------------------------------------------------------------------------------

def compare(options):
    """Lists the mutants that the old suite finds and the new one does not. Returns how many those are."""
    old, new = (read_results(path) for path in (options.old, options.new))

    def place(row):
        return tuple(row[c] for c in COLUMNS[1:7])
    after = {place(row): row for row in new}
    lost = unknown = both = 0
    for row in old:
        now = after.get(place(row))
        where = f"{row['file']}:{row['line']}: {row['before']} -> {row['after'] or 'dropped'}"
        if now is None:
            unknown += 1
            say(f"not in the new table: {where}")
        elif row["result"] == FOUND and now["result"] == FOUND:
            both += 1
        elif row["result"] == FOUND:
            lost += 1
            say(f"lost ({now['result']}): {where}, found by {row['found by']}")
    gained = sum(row["result"] == FOUND for row in new) - both
    say(f"the old suite finds {both + lost}; the new one finds {both} of these and {gained} others"
        + (f"; {unknown} cannot be compared" if unknown else ""))
    return lost + unknown
