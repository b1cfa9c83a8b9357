"""Runs functions of scripts/lib in a shell, over a folder with one module and a stand-in for Maven."""

import os
import subprocess
from pathlib import Path

from .conftest import ROOT

PASSED_REPORT = '<testsuite><testcase name="lands"/></testsuite>'


class SuiteShell:
    """A shell with the functions of scripts/lib, over a folder with one module and a stand-in for Maven."""

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
        program.write_text(f'#!/bin/sh\necho "$@" >{self.folder}/asked\n{written}exit {status}\n')
        program.chmod(0o755)

    def command_line(self, *commands: str, workers: int = 2) -> list[str]:
        """Command line of a shell that runs commands with the functions at hand."""
        parts = " ".join(
            f". {ROOT}/scripts/lib/{part}.sh;"
            for part in ("say", "settings", "build", "lanes", "suites", "rounds")
        )
        here = f"TEST_LOGS={self.folder}/test RESULTS={self.folder}/results.tsv WORKERS={workers}"
        begin = "exec {LOCK}>/dev/null; : >>$RESULTS; watch_for_interruption"
        script = f"set -euo pipefail; ROOT={self.folder}; {parts} {here}; {begin}; {'; '.join(commands)}"
        return ["bash", "-c", script]

    def environment(self) -> dict[str, str]:
        inherited = {name: value for name, value in os.environ.items() if not name.startswith("DRONEMAP_")}
        return inherited | {"PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"}

    def run(self, *commands: str, workers: int = 2) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            self.command_line(*commands, workers=workers),
            env=self.environment(),
            text=True,
            capture_output=True,
            check=False,
            timeout=60,
        )

    def results(self, *commands: str, workers: int = 2) -> list[str]:
        """Results that the commands record, as `report.py` reads them, without paths of logs and reports."""
        outcome = self.run(*commands, workers=workers)
        assert outcome.returncode == 0, outcome.stderr
        lines = (self.folder / "results.tsv").read_text().splitlines()
        return [" ".join(line.split("\t")[:2]) for line in lines]
