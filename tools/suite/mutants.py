"""Measures how many small faults of the program its tests find. See MUTANTS.md."""
import argparse
import os
import signal
import sys
from pathlib import Path

from common import OWN_TREE


def arguments():
    parser = argparse.ArgumentParser(prog="mutants.sh", description=__doc__)
    steps = parser.add_subparsers(dest="step", required=True)
    jobs = max(os.cpu_count() or 1, 1)
    for name, what in (("draw", "draws the mutants"), ("apply", "copies the tree and puts the mutants in"),
                       ("build", "builds the copy"), ("reach", "finds out which cases reach which mutants"),
                       ("run", "tries each mutant"), ("all", "all of these in turn")):
        step = steps.add_parser(name, help=what)
        step.add_argument("--out", type=lambda text: Path(text).resolve(), required=True, help="folder of the measurement")
        step.add_argument("--source", type=lambda text: Path(text).resolve(), default=OWN_TREE, help="tree to mutate")
        step.add_argument("-j", "--jobs", type=int, default=jobs)
        every = name == "all"
        if name == "draw" or every:
            step.add_argument("--seed", type=int, default=1)
            step.add_argument("--count", type=int, default=200)
            step.add_argument("--only", default="", help="beginnings of file names, separated by commas")
        if name == "build" or every:
            step.add_argument("--targets", default="", help="what to build, separated by commas; empty: all")
            step.add_argument("--flags", default="-O1 -g1", help="optimisation")
        if name in ("reach", "run") or every:
            step.add_argument("--cases", default="", help="file with names of cases, one a line; only these are run")
        if name == "run" or every:
            step.add_argument("--results", default="results.tsv", help="name of the table in the folder")
            step.add_argument("--all-cases", action="store_true", help="name every case that finds a mutant")
            step.add_argument("--budget", type=float, default=0,
                              help="s of cases that a mutant may take; dearer cases are not tried; 0: no limit")
            step.add_argument("--patience", type=float, default=10, help="s, beside ten times a case's usual time")
    step = steps.add_parser("compare", help="lists the mutants that the old suite finds and the new one does not")
    step.add_argument("old", type=Path)
    step.add_argument("new", type=Path)
    return parser.parse_args()


def main():
    # Each step loads only what it needs: libclang is for the draw alone.
    options = arguments()
    if options.step == "compare":
        import score
        return 1 if score.compare(options) else 0
    for step in ("draw", "apply", "build", "reach", "run"):
        if options.step not in (step, "all"):
            continue
        if step == "draw":
            import draw
            draw.draw(options)
        elif step in ("apply", "build"):
            import tree
            getattr(tree, step)(options)
        else:
            import score
            getattr(score, step)(options)
    return 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("mutants: stopped; the same step goes on from here", file=sys.stderr)
        sys.exit(130)
