"""Trials: evidence that takes hours, such as hundreds of seeds or repeats under load, gathered bit by bit.

Usage: trials.py [NAME] [--minutes M] [--again]

scripts/trials.toml declares them. A trial consists of units; the command of a unit passes by ending with 0.
What is done stands in .tools/trials/NAME.tsv, a line for each unit, so that a trial that was interrupted goes
on where it was; no unit is run twice, whatever came of it. docs/trials/NAME.tsv shows the same to readers.
"""

import argparse
import contextlib
import ctypes
import fcntl
import os
import re
import shlex
import signal
import subprocess
import sys
import time
import tomllib
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NoReturn

ROOT = Path(__file__).resolve().parents[1]
FAILED, USAGE = 1, 2
NOT_RUNNABLE = (126, 127)
INTERRUPTED = 130
ENDED_FROM_OUTSIDE = (129, INTERRUPTED, 143)
MOST_MINUTES = 100_000
END_SECONDS = 30
SAMPLE_SECONDS = 5
PR_SET_PDEATHSIG = 1
RANGE = re.compile(r"(\d{1,6})-(\d{1,6})")
NAME = re.compile(r"[a-z][a-z0-9-]*")
KEYS: dict[str, type | tuple[type, ...]] = {
    "says": str,
    "run": str,
    "units": (str, list),
    "files": str,
    "except": list,
    "busy": int,
    "needs": str,
}
COLUMNS = ("unit", "result", "seconds", "load before", "load", "cores", "commit", "processor")


class Refused(Exception):
    """A sentence for whoever asked, and the exit code."""

    def __init__(self, sentence: str, code: int = FAILED) -> None:
        super().__init__(sentence)
        self.code = code


def tell(sentence: str) -> None:
    print(f"dronemap: {sentence}", file=sys.stderr, flush=True)


# --- what is declared ---


@dataclass(frozen=True)
class Trial:
    """One entry of the table."""

    name: str
    says: str
    run: str
    units: list[str]
    busy: int = 0
    needs: str | None = None

    def command(self, unit: str) -> list[str]:
        return [word.replace("{unit}", unit) for word in shlex.split(self.run)]


def units_of(name: str, entry: dict[str, Any], root: Path) -> list[str]:
    if "files" in entry:
        left_out = set(entry.get("except", []))
        files = sorted(str(path.relative_to(root)) for path in root.glob(entry["files"]))
        return [file for file in files if file not in left_out]
    units = entry.get("units")
    if isinstance(units, list):
        return [str(unit) for unit in units]
    bounds = RANGE.fullmatch(units or "")
    if bounds is None or int(bounds[1]) > int(bounds[2]):
        raise Refused(
            f"The trial '{name}' has the units '{units}'; they must be a range such as 1-20, or a list."
        )
    return [str(number) for number in range(int(bounds[1]), int(bounds[2]) + 1)]


def trial_of(name: str, entry: dict[str, Any], root: Path) -> Trial:
    if NAME.fullmatch(name) is None:
        raise Refused(f"The trial '{name}' must have a name of small letters, digits and hyphens.")
    for key, value in entry.items():
        if key not in KEYS or not isinstance(value, KEYS[key]):
            raise Refused(f"The trial '{name}' has '{key} = {value}', which no trial may have.")
    if "says" not in entry or "run" not in entry:
        raise Refused(f"The trial '{name}' needs what it says and what it runs.")
    units = units_of(name, entry, root)
    if not units or len(set(units)) != len(units) or any(re.search(r"\s", unit) for unit in units):
        raise Refused(f"The trial '{name}' needs units, each of them once and without spaces.")
    return Trial(name, entry["says"], entry["run"], units, entry.get("busy", 0), entry.get("needs"))


def declared(root: Path) -> dict[str, Trial]:
    file = root / "scripts" / "trials.toml"
    try:
        table = tomllib.loads(file.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as error:
        raise Refused(f"{file} is not readable: {error}") from error
    return {name: trial_of(name, entry, root) for name, entry in table.items()}


# --- what is done ---


@dataclass(frozen=True)
class Finished:
    """One unit that ran to its end."""

    unit: str
    result: str
    seconds: str
    load_before: str
    load: str
    cores: str
    commit: str
    processor: str

    def line(self) -> str:
        values = (self.unit, self.result, self.seconds, self.load_before, self.load, self.cores)
        return "\t".join((*values, self.commit, self.processor))

    @property
    def passed(self) -> bool:
        return self.result == "passed"


@dataclass
class State:
    """What is done of a trial. A line that is damaged, or of another command, counts for nothing."""

    trial: Trial
    root: Path
    finished: dict[str, Finished] = field(default_factory=dict)
    complaints: list[str] = field(default_factory=list)

    @property
    def file(self) -> Path:
        return self.root / ".tools" / "trials" / f"{self.trial.name}.tsv"

    @property
    def results(self) -> Path:
        return self.root / "docs" / "trials" / f"{self.trial.name}.tsv"

    @property
    def missing(self) -> list[str]:
        return [unit for unit in self.trial.units if unit not in self.finished]

    @property
    def failed(self) -> int:
        return sum(not one.passed for one in self.finished.values())

    def sum_of(self, line: str) -> str:
        return f"{zlib.crc32(f'{self.trial.run} {self.trial.busy} {line}'.encode()):08x}"

    def read(self) -> "State":
        lines = self.file.read_bytes().split(b"\n") if self.file.exists() else []
        for number, raw in enumerate(lines, 1):
            if not raw:
                continue
            line, _, check = raw.decode(errors="replace").rpartition("\t")
            values = line.split("\t")
            if len(values) != len(COLUMNS) or check != self.sum_of(line) or values[0] in self.finished:
                told = (
                    f"Line {number} of {self.file} is damaged, or of another command, and counts for nothing"
                )
                self.complaints.append(f"{told}: {raw[:60].decode(errors='replace')}")
            elif values[0] in self.trial.units:
                self.finished[values[0]] = Finished(*values)
        return self

    def add(self, one: Finished) -> None:
        self.finished[one.unit] = one
        done = [self.finished[unit] for unit in self.trial.units if unit in self.finished]
        replace(self.file, "".join(f"{line}\t{self.sum_of(line)}\n" for line in (one.line() for one in done)))
        self.publish()

    def publish(self) -> None:
        done = [self.finished[unit] for unit in self.trial.units if unit in self.finished]
        busy = f", beside {self.trial.busy} busy process(es)" if self.trial.busy else ""
        head = [
            f"# {self.trial.name}: {self.trial.says}",
            f"# each unit: {self.trial.run}{busy}",
            f"# {len(done)} of {len(self.trial.units)} units done, {self.failed} failed",
            "\t".join(COLUMNS),
        ]
        replace(self.results, "\n".join([*head, *(one.line() for one in done)]) + "\n")

    def forget(self) -> None:
        for file in (self.file, self.results):
            file.unlink(missing_ok=True)
        self.finished, self.complaints = {}, []

    def how_far(self) -> str:
        failed = f", {self.failed} failed" if self.failed else ""
        return f"{len(self.finished)} of {len(self.trial.units)}{failed}"


def replace(file: Path, text: str) -> None:
    """All of it or nothing, whenever the process or the machine ends."""
    file.parent.mkdir(parents=True, exist_ok=True)
    new = file.with_suffix(".new")
    with new.open("w", encoding="utf-8") as output:
        output.write(text)
        output.flush()
        os.fsync(output.fileno())
    new.replace(file)


# --- where it is done ---


def commit_of(root: Path) -> str:
    """With a plus where files differ from it; results of trials are none of what is tried."""

    def git(*arguments: str) -> str:
        outcome = subprocess.run(["git", *arguments], cwd=root, text=True, capture_output=True, check=False)
        return outcome.stdout.strip() if outcome.returncode == 0 else ""

    commit = git("rev-parse", "--short=10", "HEAD") or "unknown"
    return commit + ("+" if git("status", "--porcelain", "--", ".", ":!docs/trials") else "")


def processor() -> str:
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return " ".join(line.partition(":")[2].split())
    return os.uname().machine


def ends_with_parent() -> None:
    """A trial that is killed leaves nothing behind that works on."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)


@contextlib.contextmanager
def busy_processes(count: int) -> Iterator[None]:
    started = [
        subprocess.Popen(
            [sys.executable, "-c", "while True: pass"], stdin=subprocess.DEVNULL, preexec_fn=ends_with_parent
        )
        for _ in range(count)
    ]
    try:
        yield
    finally:
        for process in started:
            process.kill()
        for process in started:
            process.wait()


def end(process: subprocess.Popen[bytes]) -> None:
    """It may tidy up; then all that it started is killed."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGTERM)
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(END_SECONDS)
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def run_unit(trial: Trial, unit: str, root: Path, log: Path) -> Finished:
    commit, before, started = commit_of(root), os.getloadavg()[0], time.monotonic()
    loads = [before]
    log.parent.mkdir(parents=True, exist_ok=True)
    with log.open("wb") as output, busy_processes(trial.busy):
        try:
            process = subprocess.Popen(
                trial.command(unit),
                cwd=root,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                start_new_session=True,
                preexec_fn=ends_with_parent,
            )
        except OSError as error:
            raise Refused(f"The command of '{trial.name}' cannot be run: {error}") from error
        try:
            while True:
                try:
                    code = process.wait(SAMPLE_SECONDS)
                    break
                except subprocess.TimeoutExpired:
                    loads.append(os.getloadavg()[0])
        except BaseException:
            end(process)
            raise
    if code in NOT_RUNNABLE:
        raise Refused(f"The command of '{trial.name}' cannot be run. Details: {log}")
    if code in ENDED_FROM_OUTSIDE or code < 0:
        raise Refused(f"The unit {unit} was ended from outside, so it counts for nothing. Details: {log}")
    seconds = time.monotonic() - started
    return Finished(
        unit,
        "passed" if code == 0 else f"failed ({code})",
        f"{seconds:.1f}",
        f"{before:.1f}",
        f"{sum(loads) / len(loads):.1f}",
        str(len(os.sched_getaffinity(0))),
        commit,
        processor(),
    )


@contextlib.contextmanager
def alone(file: Path, sentence: str, patience: float = 0) -> Iterator[None]:
    file.parent.mkdir(parents=True, exist_ok=True)
    until = time.monotonic() + patience
    with file.open("a") as lock:
        while True:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if time.monotonic() >= until:
                    raise Refused(sentence) from None
                time.sleep(0.2)
        yield


def go_on(state: State, minutes: float) -> None:
    """Runs units until all are done, or until the next one would probably not end in time; at least one."""
    trial, until = state.trial, time.monotonic() + 60 * minutes
    lock = state.root / ".tools" / "lock"
    for number, unit in enumerate(state.missing):
        longest = max((float(one.seconds) for one in state.finished.values()), default=0)
        if number and time.monotonic() + longest > until:
            print(f"The time is over; run the same command again to go on with unit {unit}.")
            break
        # What an earlier trial left may need a moment to end; a unit that finds it would fail for it.
        with alone(
            lock, "Another ./dronemap is at work in this checkout. Wait until it is done.", END_SECONDS
        ):
            pass
        log = state.file.parent / trial.name / f"{re.sub('[^A-Za-z0-9.]', '-', unit)}.log"
        one = run_unit(trial, unit, state.root, log)
        state.add(one)
        failed = "" if one.passed else f" See {log}"
        print(
            f"{trial.name}: unit {unit} {one.result} in {one.seconds} s, {state.how_far()}.{failed}",
            flush=True,
        )


def list_all(trials: dict[str, Trial], root: Path) -> int:
    states = [State(trial, root).read() for trial in trials.values()]
    wide = max((len(state.how_far()) for state in states), default=0)
    for state in states:
        print(f"{state.trial.name:<{max(map(len, trials))}}  {state.how_far():<{wide}}  {state.trial.says}")
    for complaint in (complaint for state in states for complaint in state.complaints):
        tell(complaint)
    return 0


def run_one(trial: Trial, root: Path, minutes: float, again: bool) -> int:
    if trial.needs is not None and not os.environ.get(trial.needs):
        raise Refused(f"The trial '{trial.name}' needs {trial.needs}. See docs/settings.md")
    state = State(trial, root)
    with alone(state.file.with_suffix(".lock"), f"The trial '{trial.name}' is being run already."):
        if again:
            state.forget()
        for complaint in state.read().complaints:
            tell(complaint)
        print(f"{trial.name}: {trial.says} {state.how_far()}.", flush=True)
        go_on(state, minutes)
        state.publish()
    print(f"{trial.name}: {state.how_far()}. Results: {state.results}")
    return FAILED if state.failed else 0


class Words(argparse.ArgumentParser):
    """Says what is wrong in one sentence."""

    def error(self, message: str) -> NoReturn:
        tell(f"trials: {message}. See ./dronemap help")
        sys.exit(USAGE)


def minutes_of(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 1 <= int(text) <= MOST_MINUTES:
        raise argparse.ArgumentTypeError(f"'{text}' must be a number from 1 to {MOST_MINUTES}")
    return int(text)


def main(arguments: list[str], root: Path = ROOT) -> int:
    words = Words(description="Lists the trials, or goes on with one.")
    words.add_argument("name", nargs="?")
    words.add_argument("--minutes", type=minutes_of, default=60)
    words.add_argument("--again", action="store_true", help="forget what is done")
    chosen = words.parse_args(arguments)
    # Whoever started this may have let it ignore interruptions.
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.default_int_handler)
    try:
        trials = declared(root)
        if chosen.name is None:
            if arguments:
                words.error("--minutes and --again need the name of a trial")
            return list_all(trials, root)
        if chosen.name not in trials:
            raise Refused(f"There is no trial '{chosen.name}'. ./dronemap trials lists them.", USAGE)
        return run_one(trials[chosen.name], root, chosen.minutes, chosen.again)
    except Refused as refused:
        tell(str(refused))
        return refused.code
    except KeyboardInterrupt:
        tell("Interrupted. The unit under way counts for nothing: run the same command again and it goes on.")
        return INTERRUPTED


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
