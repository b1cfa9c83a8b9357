"""Runs one unit of a trial: its process, busy processes beside it, and the machine that it ran on."""

import contextlib
import ctypes
import fcntl
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

from trial_results import UnitResult
from trial_table import Trial, TrialRefused

NOT_RUNNABLE = (126, 127)
INTERRUPTED = 130
ENDED_FROM_OUTSIDE = (129, INTERRUPTED, 143)
END_SECONDS = 30
SAMPLE_SECONDS = 5
PR_SET_PDEATHSIG = 1


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


def end_with_parent() -> None:
    """A trial that is killed leaves nothing behind that works on."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)


@contextlib.contextmanager
def busy_processes(count: int) -> Iterator[None]:
    started = [
        subprocess.Popen(
            [sys.executable, "-c", "while True: pass"], stdin=subprocess.DEVNULL, preexec_fn=end_with_parent
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


def end_process_group(process: subprocess.Popen[bytes]) -> None:
    """It may tidy up; then all that it started is killed."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGTERM)
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(END_SECONDS)
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def run_unit(trial: Trial, unit: str, root: Path, log: Path) -> UnitResult:
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
                preexec_fn=end_with_parent,
            )
        except OSError as error:
            raise TrialRefused(f"The command of '{trial.name}' cannot be run: {error}") from error
        try:
            while True:
                try:
                    code = process.wait(SAMPLE_SECONDS)
                    break
                except subprocess.TimeoutExpired:
                    loads.append(os.getloadavg()[0])
        except BaseException:
            end_process_group(process)
            raise
    if code in NOT_RUNNABLE:
        raise TrialRefused(f"The command of '{trial.name}' cannot be run. Details: {log}")
    if code in ENDED_FROM_OUTSIDE or code < 0:
        raise TrialRefused(
            f"The unit {unit} was ended from outside, so it counts for nothing. Details: {log}"
        )
    seconds = time.monotonic() - started
    return UnitResult(
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
def exclusive_lock(file: Path, sentence: str, patience: float = 0) -> Iterator[None]:
    file.parent.mkdir(parents=True, exist_ok=True)
    until = time.monotonic() + patience
    with file.open("a") as lock:
        while True:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if time.monotonic() >= until:
                    raise TrialRefused(sentence) from None
                time.sleep(0.2)
        yield
