"""Runs trials: evidence that takes hours, such as hundreds of seeds or repeats under load.

Usage: trials.py [NAME] [--minutes M] [--again]

scripts/trials.toml declares them. A trial consists of units; the command of a unit passes by ending with 0.
What is done stands in .tools/trials/NAME.tsv, a line for each unit, so that a trial that was interrupted goes
on where it was; no unit is run twice, whatever came of it. docs/trials/NAME.tsv shows the same to readers.
"""

import argparse
import re
import signal
import sys
import time
from pathlib import Path
from typing import NoReturn

from trial_results import TrialState
from trial_table import FAILED, Trial, TrialRefused, load_trials
from trial_units import END_SECONDS, INTERRUPTED, exclusive_lock, run_unit

ROOT = Path(__file__).resolve().parents[1]
USAGE = 2
MOST_MINUTES = 100_000


def print_error(sentence: str) -> None:
    print(f"dronemap: {sentence}", file=sys.stderr, flush=True)


def run_missing_units(state: TrialState, minutes: float) -> None:
    """Runs units until all are done, or until the next one would probably not end in time; at least one."""
    trial, until = state.trial, time.monotonic() + 60 * minutes
    lock = state.root / ".tools" / "lock"
    provable = [unit for unit in state.missing if trial.missing_setting(unit) is None]
    for number, unit in enumerate(provable):
        longest = max((float(one.seconds) for one in state.finished.values()), default=0)
        if number and time.monotonic() + longest > until:
            print(f"The time is over; run the same command again to go on with unit {unit}.")
            break
        # What an earlier trial left may need a moment to end; a unit that finds it would fail for it.
        with exclusive_lock(
            lock, "Another ./dronemap is at work in this checkout. Wait until it is done.", END_SECONDS
        ):
            pass
        log = state.file.parent / trial.name / f"{re.sub('[^A-Za-z0-9.]', '-', unit)}.log"
        one = run_unit(trial, unit, state.root, log)
        state.add(one)
        failed = "" if one.passed else f" See {log}"
        print(
            f"{trial.name}: unit {unit} {one.result} in {one.seconds} s, {state.progress()}.{failed}",
            flush=True,
        )


def list_all(trials: dict[str, Trial], root: Path) -> int:
    states = [TrialState(trial, root).read() for trial in trials.values()]
    wide = max((len(state.progress()) for state in states), default=0)
    for state in states:
        name = f"{state.trial.name:<{max(map(len, trials))}}"
        print(f"{name}  {state.progress():<{wide}}  {state.trial.description}")
    for sentence in (sentence for state in states for sentence in state.damaged_lines):
        print_error(sentence)
    return 0


def run_one(trial: Trial, root: Path, minutes: float, again: bool) -> int:
    settings = [trial.missing_setting(unit) for unit in trial.units]
    if None not in settings:
        needed = " or ".join(sorted({str(setting) for setting in settings}))
        raise TrialRefused(f"Not proved: the trial '{trial.name}' needs {needed}. See docs/settings.md")
    for unit, setting in zip(trial.units, settings, strict=True):
        if setting is not None:
            print_error(
                f"The unit {unit} is left out and not proved: it needs {setting}. See docs/settings.md"
            )
    state = TrialState(trial, root)
    with exclusive_lock(state.file.with_suffix(".lock"), f"The trial '{trial.name}' is being run already."):
        if again:
            state.discard()
        for sentence in state.read().damaged_lines:
            print_error(sentence)
        print(f"{trial.name}: {trial.description} {state.progress()}.", flush=True)
        run_missing_units(state, minutes)
        state.publish()
    print(f"{trial.name}: {state.progress()}. Results: {state.results}")
    return FAILED if state.failed else 0


class OneSentenceParser(argparse.ArgumentParser):
    """An argument parser that prints what is wrong in one sentence."""

    def error(self, message: str) -> NoReturn:
        print_error(f"trials: {message}. See ./dronemap help")
        sys.exit(USAGE)


def minutes_of(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 1 <= int(text) <= MOST_MINUTES:
        raise argparse.ArgumentTypeError(f"'{text}' must be a number from 1 to {MOST_MINUTES}")
    return int(text)


def main(arguments: list[str], root: Path = ROOT) -> int:
    parser = OneSentenceParser(description="Lists the trials, or goes on with one.")
    parser.add_argument("name", nargs="?")
    parser.add_argument("--minutes", type=minutes_of, default=60)
    parser.add_argument("--again", action="store_true", help="forget what is done")
    chosen = parser.parse_args(arguments)
    # Whoever started this may have let it ignore interruptions.
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.default_int_handler)
    try:
        trials = load_trials(root)
        if chosen.name is None:
            if arguments:
                parser.error("--minutes and --again need the name of a trial")
            return list_all(trials, root)
        if chosen.name not in trials:
            raise TrialRefused(f"There is no trial '{chosen.name}'. ./dronemap trials lists them.", USAGE)
        return run_one(trials[chosen.name], root, chosen.minutes, chosen.again)
    except TrialRefused as refused:
        print_error(str(refused))
        return refused.code
    except KeyboardInterrupt:
        print_error(
            "Interrupted. The unit under way counts for nothing: run the same command again and it goes on."
        )
        return INTERRUPTED


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
