"""Counts what the suites of `./dronemap test` left behind and prints the table that ends the run.

Input: a file of tab-separated lines `suite, kind, what, log`, where kind is
  passed | failed   one check that stands for itself
  skipped           `what` is the reason
  junit             `what` is a pattern of JUnit reports
  named             the same of a program that calls tests skipped that nobody asked for; those have no reason
  status            the program of the suite failed; counts only when no report of the suite shows a failure
What each failed test said stands between the table and the end, then which tests took longest.
Lines of a test's output that begin with "tried on: " say what it ran on and are repeated below the table.
With `--rounds N` the tests were run N times, and how often each failed is told. Once failed is failed.
Exit code 1 when anything failed.
"""

import argparse
import glob
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

TRIED_ON = "tried on: "
# Of what a failed test said: enough to see why without the log of another machine.
MOST_LINES, MOST_COLUMNS = 30, 400
SLOWEST = 10
NO_REASON = "no reason given"


@dataclass
class Suite:
    """Counts of one suite, the names of what failed, the reasons of what was skipped, and what it ran on."""

    passed: int = 0
    failures: Counter[str] = field(default_factory=Counter)
    skips: Counter[str] = field(default_factory=Counter)
    adapters: list[str] = field(default_factory=list)
    messages: dict[str, str] = field(default_factory=dict)
    times: Counter[str] = field(default_factory=Counter)
    seconds: dict[str, float] = field(default_factory=dict)
    logs_of_failures: set[str] = field(default_factory=set)

    @property
    def failed(self) -> int:
        return self.failures.total()

    @property
    def skipped(self) -> int:
        return self.skips.total()

    @property
    def ran(self) -> int:
        return self.passed + self.failed

    def add_time(self, name: str, seconds: float) -> None:
        """Adds the time of a test; of several rounds the longest counts."""
        self.seconds[name] = max(self.seconds.get(name, 0), seconds)


def first_line(text: str) -> str:
    lines = text.strip().splitlines()
    return lines[0].strip() if lines else NO_REASON


def reason_of(skipped: ElementTree.Element) -> str:
    reason = skipped.get("message") or skipped.text or ""
    for prefix in ("Assumption failed: ", "org.opentest4j.TestAbortedException: ", "Skipped: "):
        reason = reason.removeprefix(prefix)
    return first_line(reason)


def seconds_of(element: ElementTree.Element) -> float:
    try:
        return float((element.get("time") or "0").replace(",", ""))
    except ValueError:
        return 0


def add_case(suite: Suite, case: ElementTree.Element) -> None:
    name = f"{case.get('classname', '')} {case.get('name', '')}".strip()
    skipped = case.find("skipped")
    broken = case.find("failure") if case.find("failure") is not None else case.find("error")
    suite.times[name] += 1
    if broken is not None:
        suite.failures[name] += 1
        suite.messages.setdefault(name, (broken.text or broken.get("message") or "").strip())
    elif skipped is not None:
        reason = reason_of(skipped)
        suite.skips[f"{reason}: {name}" if reason == NO_REASON else reason] += 1
    else:
        suite.passed += 1
    suite.add_time(name, seconds_of(case))


def add_setup(suite: Suite, group: ElementTree.Element) -> None:
    """Adds the time of a class beside its tests, such as starting what they share."""
    cases = group.findall("testcase")
    name = group.get("name", "")
    if cases and all(case.get("classname") == name for case in cases):
        suite.add_time(
            f"{name} (beside its tests)", seconds_of(group) - sum(seconds_of(case) for case in cases)
        )


def add_reports(suite: Suite, pattern: str, named: bool = False) -> None:
    for path in sorted(glob.glob(pattern)):  # noqa: PTH207 the pattern is absolute
        try:
            root = ElementTree.parse(path).getroot()
        except ElementTree.ParseError as error:
            suite.failures[f"{path} is not readable: {error}"] += 1
            continue
        for case in root.iter("testcase"):
            skipped = case.find("skipped")
            if named and skipped is not None and reason_of(skipped) == NO_REASON:
                continue
            add_case(suite, case)
        for group in root.iter("testsuite"):
            add_setup(suite, group)
        for output in root.iter("system-out"):
            lines = (output.text or "").splitlines()
            suite.adapters += [line.removeprefix(TRIED_ON) for line in lines if line.startswith(TRIED_ON)]


def read_results(path: Path) -> dict[str, Suite]:
    suites: dict[str, Suite] = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        name, kind, what, log = line.split("\t")
        suite = suites.setdefault(name, Suite())
        before = suite.failed
        if kind == "passed":
            suite.passed += 1
        elif kind == "failed":
            suite.failures[f"{what} (see {log})"] += 1
        elif kind == "skipped":
            suite.skips[what] += 1
        elif kind in ("junit", "named"):
            add_reports(suite, what, kind == "named")
        elif log not in suite.logs_of_failures:
            suite.failures[f"{what} ended with an error outside any test (see {log})"] += 1
        if suite.failed > before:
            suite.logs_of_failures.add(log)
    return suites


def reason_lines(suite: Suite) -> list[str]:
    reasons = [f"{count} × {reason}" if count > 1 else reason for reason, count in suite.skips.most_common()]
    return [f"FAILED {name}" for name in suite.failures] + [f"not proved: {reason}" for reason in reasons]


def print_table(suites: dict[str, Suite]) -> None:
    print()
    print(f"{'suite':<12} {'ran':>6} {'passed':>7} {'failed':>7} {'skipped':>8}  why")
    for name, suite in suites.items():
        whys = reason_lines(suite) or [""]
        counts = f"{suite.ran:>6} {suite.passed:>7} {suite.failed:>7} {suite.skipped:>8}"
        print(f"{name:<12} {counts}  {whys[0]}".rstrip())
        for why in whys[1:]:
            print(f"{'':<45}{why}")
    print()


def print_reasons(suites: dict[str, Suite]) -> None:
    """Prints the first and the last lines of each failed test's message."""
    for name, message in (entry for suite in suites.values() for entry in suite.messages.items()):
        lines = [line[:MOST_COLUMNS] for line in message.splitlines()]
        if len(lines) > MOST_LINES:
            half = MOST_LINES // 2
            lines = [*lines[:half], "…", *lines[-half:]]
        print(f"FAILED {name}", *(f"    {line}" for line in lines), "", sep="\n")


def print_slowest(suites: dict[str, Suite]) -> None:
    times = [
        (seconds, name, test) for name, suite in suites.items() for test, seconds in suite.seconds.items()
    ]
    slowest = [entry for entry in sorted(times, key=lambda entry: -entry[0]) if entry[0] >= 0.05][:SLOWEST]
    if slowest:
        print(f"The {len(slowest)} slowest:" if len(slowest) > 1 else "The slowest:")
        for took_seconds, name, test in slowest:
            print(f"{took_seconds:>9.1f} s  {name}: {test}")
        print()


def print_rounds(suites: dict[str, Suite], rounds: int) -> None:
    tests = {(name, test): times for name, suite in suites.items() for test, times in suite.times.items()}
    failed = {key: suites[key[0]].failures[key[1]] for key in tests if suites[key[0]].failures[key[1]]}
    print(f"In {rounds} rounds {len(failed)} of {len(tests)} tests failed at least once.")
    for (name, test), count in sorted(failed.items(), key=lambda entry: -entry[1]):
        print(f"  failed {count} of {tests[name, test]} times: {name}: {test}")
    print()


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description="Prints the table that ends a test run.")
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("results", type=Path)
    chosen = parser.parse_args(arguments)
    suites = read_results(chosen.results)
    print_table(suites)
    print_reasons(suites)
    print_slowest(suites)
    if chosen.rounds > 1:
        print_rounds(suites, chosen.rounds)
    passed = sum(suite.passed for suite in suites.values())
    failed = sum(suite.failed for suite in suites.values())
    skipped = sum(suite.skipped for suite in suites.values())
    for line in dict.fromkeys(line for suite in suites.values() for line in suite.adapters):
        print(f"{TRIED_ON}{line}")
    if skipped:
        print("What was skipped is not proved by this run.")
    if passed + failed == 0:
        print("Nothing ran.")
    print(f"{passed} passed, {failed} failed, {skipped} skipped", flush=True)
    return 1 if failed or passed == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
