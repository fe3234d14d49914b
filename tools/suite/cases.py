"""Reads the CTest cases of a build, runs them, and judges their results as CTest does."""
import contextlib
import dataclasses
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import threading
import time
from pathlib import Path

from common import in_parallel, stop

PASSED, FAILED, SKIPPED = "passed", "failed", "skipped"
TIME_LIMIT = "time limit"
USUAL_LIMIT = 1800  # limit of a case without one of its own (s)
MEMORY = 8 << 30    # address space of a case (bytes)
DISK = 2 << 30      # size of one file that a case writes (bytes)


@dataclasses.dataclass
class Case:
    name: str
    command: list
    properties: dict
    before: list = dataclasses.field(default_factory=list)  # cases that must run first (CTest's fixtures)

    @property
    def limit(self):
        """Limit for the case and the cases before it together (s)."""
        return float(self.properties.get("TIMEOUT", USUAL_LIMIT)) + sum(other.limit for other in self.before)

    def locks(self):
        """Names of the case's locks. Two cases with a common lock never run at the same time. A case also has
        a lock of its own: two runs of it, for two mutants, might write files of the same name."""
        names = {f"case {self.name}", *as_list(self.properties.get("RESOURCE_LOCK"))}
        for other in self.before:
            names |= other.locks()
        return names


@dataclasses.dataclass
class Outcome:
    verdict: str
    how: str
    seconds: float


class Stopped(Exception):
    """The user wants to stop."""


def as_list(value):
    return value if isinstance(value, list) else [value] if value else []


def read_cases(folder, names_file):
    """All cases of the build that can be run, by name. `names_file` restricts them; it has a name a line."""
    shown = subprocess.run(["ctest", "--test-dir", str(folder / "build"), "--show-only=json-v1"], capture_output=True,
                           text=True)
    if shown.returncode != 0:
        stop(f"ctest cannot list the cases; run the step build first: {shown.stderr.strip()}")
    cases = {}
    for test in json.loads(shown.stdout)["tests"]:
        properties = {p["name"]: p["value"] for p in test.get("properties", [])}
        # A program that was not built has no command, or one without a file.
        if test.get("command") and shutil.which(test["command"][0]) and not properties.get("DISABLED"):
            cases[test["name"]] = Case(test["name"], test["command"], properties)
    add_fixtures(cases)
    if not names_file:
        return cases
    wanted = {line.strip() for line in Path(names_file).read_text().splitlines()} - {""}
    return {name: case for name, case in cases.items() if name in wanted}


def add_fixtures(cases):
    makers = {}
    for case in cases.values():
        for fixture in as_list(case.properties.get("FIXTURES_SETUP")):
            makers.setdefault(fixture, []).append(case)
    for case in cases.values():
        case.before = [maker for fixture in as_list(case.properties.get("FIXTURES_REQUIRED"))
                       for maker in makers.get(fixture, [])]


class Runner:
    """Runs cases, from several threads."""

    def __init__(self, folder, limited=True):
        """`limited`: limits the memory and the size of files of a case, since a mutant may need too much."""
        self.limits = limits() if limited else []
        self.scratch = folder / "tmp"
        shutil.rmtree(self.scratch, ignore_errors=True)
        self.scratch.mkdir()
        self.locks = {}
        self.guard = threading.Lock()
        self.sessions = set()
        self.stopping = False

    def stop(self):
        """Ends all cases that run; run() then raises Stopped."""
        with self.guard:
            self.stopping = True
            sessions = set(self.sessions)
        for session in sessions:
            end_session(session)

    def run(self, case, limit, variables):
        """Runs a case, and the cases that must run before it. `limit` (s) is for all together; `variables`
        are added to the environment."""
        with contextlib.ExitStack() as held:
            for name in sorted(case.locks()):
                with self.guard:
                    lock = self.locks.setdefault(name, threading.Lock())
                held.enter_context(lock)
            return self._run_held(case, limit, variables)

    def _run_held(self, case, limit, variables):
        seconds = 0.0
        for other in case.before:
            outcome = self._run_held(other, limit - seconds, variables)
            seconds += outcome.seconds
            if outcome.verdict == FAILED:
                return Outcome(FAILED, f"{other.name} before it: {outcome.how}", seconds)
        outcome = self._run_alone(case, max(limit - seconds, 1), variables)
        outcome.seconds += seconds
        return outcome

    def _run_alone(self, case, limit, variables):
        # A mutant may delete or fill folders, so each case has its own home and temporary folder.
        place = Path(tempfile.mkdtemp(dir=self.scratch, prefix=""))
        place.chmod(0o755)  # some cases run a program as another user
        (place / "t").mkdir()
        (place / "h").mkdir()
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(("XDG_", "THAUM_MUTANT"))}
        environment |= {"TMPDIR": str(place / "t"), "HOME": str(place / "h"), **variables}
        for setting in as_list(case.properties.get("ENVIRONMENT")):
            name, _, value = setting.partition("=")
            environment[name] = value
        try:
            with open(place / "output", "w+b") as output:
                code, seconds = self._run_limited(case, limit, environment, output)
                output.seek(0)
                text = output.read(16 << 20).decode(errors="replace")
        finally:
            shutil.rmtree(place, ignore_errors=True)
        verdict, how = judge(case, code, text)
        return Outcome(verdict, how, seconds)

    def _run_limited(self, case, limit, environment, output):
        """Returns the exit code, or None if the limit (s) ended the case, and the time taken (s)."""
        with self.guard:
            if self.stopping:
                raise Stopped
            begin = time.monotonic()
            process = subprocess.Popen([*self.limits, *case.command], env=environment, stdin=subprocess.DEVNULL,
                                       stdout=output, stderr=subprocess.STDOUT, start_new_session=True,
                                       cwd=case.properties.get("WORKING_DIRECTORY") or None)
            self.sessions.add(process.pid)
        try:
            code = process.wait(timeout=limit)
        except subprocess.TimeoutExpired:
            code = None
        seconds = time.monotonic() - begin
        end_session(process.pid)
        process.wait()
        with self.guard:
            self.sessions.discard(process.pid)
            if self.stopping:
                raise Stopped
        return code, seconds


def limits():
    """Prefix of a command that limits its memory and the size of its files. Only soft limits are changed."""
    result = ["prlimit", "--core=0:"]
    for name, kind, most in (("as", resource.RLIMIT_AS, MEMORY), ("fsize", resource.RLIMIT_FSIZE, DISK)):
        hard = resource.getrlimit(kind)[1]
        result.append(f"--{name}={most if hard == resource.RLIM_INFINITY else min(most, hard)}:")
    return result


def end_session(session):
    """Kills all processes of a case's session, including those that have a process group of their own."""
    for _ in range(100):
        members = [pid for pid in map(int, filter(str.isdigit, os.listdir("/proc"))) if session_of(pid) == session]
        if not members:
            return
        for pid in members:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        time.sleep(0.01)


def session_of(pid):
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0
    return 0 if fields[0] in "ZX" else int(fields[3])


def judge(case, code, text):
    """Verdict on a case and its reason, by the same rules as CTest."""
    properties = case.properties
    if code is None:
        return FAILED, TIME_LIMIT
    if str(properties.get("SKIP_RETURN_CODE", "")) == str(code):
        return SKIPPED, f"exit code {code}"
    if says_one_of(properties.get("SKIP_REGULAR_EXPRESSION"), text):
        return SKIPPED, "output"
    how = f"signal {-code}" if code < 0 else f"exit code {code}"
    good = code == 0
    if properties.get("PASS_REGULAR_EXPRESSION"):
        good, how = says_one_of(properties["PASS_REGULAR_EXPRESSION"], text), "output"
    if says_one_of(properties.get("FAIL_REGULAR_EXPRESSION"), text):
        good, how = False, "output"
    if properties.get("WILL_FAIL"):
        good = not good
    return (PASSED if good else FAILED), how


def says_one_of(expressions, text):
    return any(re.search(expression, text) for expression in as_list(expressions))


def reach_each(folder, cases, runner, jobs, reach_one):
    """Calls `reach_one` for each case and appends each result to reach.jsonl at once. Cases with the same
    lock run one after another in one thread, so that no thread waits for a lock."""
    turns = {}
    for case in cases:
        lock = as_list(case.properties.get("RESOURCE_LOCK")) or [f"case {case.name}"]
        turns.setdefault(lock[0], []).append(case)
    guard = threading.Lock()
    with open(folder / "reach.jsonl", "a") as log:
        def take_turns(some):
            for case in some:
                entry = reach_one(case)
                with guard:
                    log.write(json.dumps(entry) + "\n")
                    log.flush()
        in_parallel(runner, jobs, take_turns, sorted(turns.values(), key=len, reverse=True), "reach")


def read_reach(folder):
    """Entries that the step reach has written about each case, by name."""
    path = folder / "reach.jsonl"
    if not path.exists():
        return {}
    # An interrupted step may leave half a line.
    entries = [json.loads(line) for line in path.read_text().splitlines() if line.endswith("}")]
    return {entry["case"]: entry for entry in entries}
