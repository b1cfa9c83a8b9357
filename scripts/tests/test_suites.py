"""How `./dronemap test` runs a suite: nothing that failed may end as a line of success in the table."""

import os
import subprocess
from pathlib import Path

import pytest

from .conftest import ROOT

PASSED_REPORT = '<testsuite><testcase name="lands"/></testsuite>'
FAILED_REPORT = '<testsuite><testcase name="lands"><failure message="crashed"/></testcase></testsuite>'
BROKEN_REPORT = '<testsuite><testcase name="lands"><error message="no air"/></testcase></testsuite>'


class Bench:
    """The script's own functions over a folder with one module, and a Maven that does as it is told."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.reports = folder / "dronemap-a" / "target" / "surefire-reports"
        self.reports.mkdir(parents=True)
        for part in (".tools", "test", "bin"):
            (folder / part).mkdir()

    def maven(self, status: int, report: str | None) -> None:
        written = (
            f"mkdir -p {self.reports}\nprintf '%s' '{report}' >{self.reports}/TEST-a.xml\n" if report else ""
        )
        program = self.folder / "bin" / "mvn"
        program.write_text(f"#!/bin/sh\n{written}exit {status}\n")
        program.chmod(0o755)

    def results(self, *commands: str) -> list[str]:
        """What the commands write down, as `report.py` reads it, without the paths of logs and reports."""
        parts = " ".join(
            f". {ROOT}/scripts/lib/{part}.sh;" for part in ("say", "settings", "build", "suites")
        )
        here = f"TEST_LOGS={self.folder}/test RESULTS={self.folder}/results.tsv; exec {{LOCK}}>/dev/null"
        outcome = subprocess.run(
            ["bash", "-c", f"set -euo pipefail; ROOT={self.folder}; {parts} {here}; {'; '.join(commands)}"],
            env=os.environ | {"PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"},
            text=True,
            capture_output=True,
            check=False,
        )
        assert outcome.returncode == 0, outcome.stderr
        lines = (self.folder / "results.tsv").read_text().splitlines()
        return [" ".join(line.split("\t")[:2]) for line in lines]


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    return Bench(tmp_path)


def test_a_check_is_written_down_as_it_ended(bench: Bench) -> None:
    assert bench.results("check shell good true", "check shell bad false") == ["shell passed", "shell failed"]


def test_a_suite_that_failed_is_written_down_beside_its_reports(bench: Bench) -> None:
    found = bench.results("counted web units /no/such.xml false", "counted page units /no/such.xml true")
    assert found == ["web junit", "web status", "page junit"]


@pytest.mark.parametrize(
    ("status", "report", "expected"),
    [
        (0, PASSED_REPORT, ["java junit"]),
        (0, FAILED_REPORT, ["java junit", "java status"]),
        (0, BROKEN_REPORT, ["java junit", "java status"]),
        (1, PASSED_REPORT, ["java junit", "java status"]),
        (1, None, ["java junit", "java status"]),
    ],
    ids=["passed", "failed test", "broken test", "failed build", "no report"],
)
def test_a_failed_java_test_is_no_success_though_maven_goes_on(
    bench: Bench, status: int, report: str | None, expected: list[str]
) -> None:
    bench.maven(status, report)
    assert bench.results("suite_java test") == expected


def test_every_suite_is_part_of_a_test_run() -> None:
    """A suite that nobody calls fails nowhere."""
    body = (ROOT / "scripts" / "lib" / "suites.sh").read_text().split("command_test()")[1].split("\n}")[0]
    called = [line.split()[0] for line in body.splitlines()[1:]]
    suites = [
        "suite_shell",
        "suite_typescript",
        "suite_java",
        "suite_vulnerabilities",
        "suite_python_checks",
        "suite_pytest",
    ]
    assert [name for name in called if name.startswith("suite_")] == suites
    assert called[-1] == "report"
    assert (ROOT / ".ci" / "run").read_text().splitlines()[-1] == "exec ./dronemap test"
