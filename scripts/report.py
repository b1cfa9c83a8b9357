"""Counts what the suites of `./dronemap test` left behind and prints the table that ends the run.

Input: a file of tab-separated lines `suite, kind, what, log`, where kind is
  passed | failed   one check that stands for itself
  skipped           `what` is the reason
  junit             `what` is a pattern of JUnit reports
  status            the program of the suite failed; counts only when no report of the suite shows a failure
What each failed test said stands between the table and the end.
Lines of a test's output that begin with "tried on: " say what it ran on and are repeated below the table.
Exit code 1 when anything failed.
"""

import glob
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

TRIED_ON = "tried on: "
# Of what a failed test said: enough to see why without the log of another machine.
MOST_LINES, MOST_COLUMNS = 30, 400


@dataclass
class Suite:
    """Counts of one suite, the names of what failed, the reasons of what was skipped, and what it ran on."""

    passed: int = 0
    failed: int = 0
    failures: list[str] = field(default_factory=list)
    skips: Counter[str] = field(default_factory=Counter)
    tried_on: list[str] = field(default_factory=list)
    said: dict[str, str] = field(default_factory=dict)

    @property
    def skipped(self) -> int:
        return self.skips.total()

    @property
    def ran(self) -> int:
        return self.passed + self.failed

    def fail(self, name: str) -> None:
        self.failed += 1
        self.failures.append(name)


def first_line(text: str) -> str:
    lines = text.strip().splitlines()
    return lines[0].strip() if lines else "no reason given"


def reason_of(skipped: ElementTree.Element) -> str:
    reason = skipped.get("message") or skipped.text or ""
    for prefix in ("Assumption failed: ", "org.opentest4j.TestAbortedException: ", "Skipped: "):
        reason = reason.removeprefix(prefix)
    return first_line(reason)


def add_case(suite: Suite, case: ElementTree.Element) -> None:
    name = f"{case.get('classname', '')} {case.get('name', '')}".strip()
    skipped = case.find("skipped")
    broken = case.find("failure") if case.find("failure") is not None else case.find("error")
    if broken is not None:
        suite.fail(name)
        suite.said[name] = (broken.text or broken.get("message") or "").strip()
    elif skipped is not None:
        suite.skips[reason_of(skipped)] += 1
    else:
        suite.passed += 1


def add_reports(suite: Suite, pattern: str) -> None:
    for path in sorted(glob.glob(pattern)):  # noqa: PTH207 the pattern is absolute
        try:
            root = ElementTree.parse(path).getroot()
        except ElementTree.ParseError as error:
            suite.fail(f"{path} is not readable: {error}")
            continue
        for case in root.iter("testcase"):
            add_case(suite, case)
        for output in root.iter("system-out"):
            lines = (output.text or "").splitlines()
            suite.tried_on += [line.removeprefix(TRIED_ON) for line in lines if line.startswith(TRIED_ON)]


def read_results(path: Path) -> dict[str, Suite]:
    suites: dict[str, Suite] = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        name, kind, what, log = line.split("\t")
        suite = suites.setdefault(name, Suite())
        if kind == "passed":
            suite.passed += 1
        elif kind == "failed":
            suite.fail(f"{what} (see {log})")
        elif kind == "skipped":
            suite.skips[what] += 1
        elif kind == "junit":
            add_reports(suite, what)
        elif not suite.failures:
            suite.fail(f"{what} ended with an error outside any test (see {log})")
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
    """The first and the last lines of what each failed test said."""
    for name, said in (entry for suite in suites.values() for entry in suite.said.items()):
        lines = [line[:MOST_COLUMNS] for line in said.splitlines()]
        if len(lines) > MOST_LINES:
            half = MOST_LINES // 2
            lines = [*lines[:half], "…", *lines[-half:]]
        print(f"FAILED {name}", *(f"    {line}" for line in lines), "", sep="\n")


def main(arguments: list[str]) -> int:
    suites = read_results(Path(arguments[0]))
    print_table(suites)
    print_reasons(suites)
    passed = sum(suite.passed for suite in suites.values())
    failed = sum(suite.failed for suite in suites.values())
    skipped = sum(suite.skipped for suite in suites.values())
    for line in (line for suite in suites.values() for line in suite.tried_on):
        print(f"{TRIED_ON}{line}")
    if skipped:
        print("What was skipped is not proved by this run.")
    print(f"{passed} passed, {failed} failed, {skipped} skipped", flush=True)
    return 1 if failed or passed == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
