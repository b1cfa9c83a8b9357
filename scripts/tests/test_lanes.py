"""Workers and lanes of `./dronemap test`: two at the same time, and never more than workers."""

import re
import signal
import subprocess
import tomllib
from pathlib import Path

import pytest

from .conftest import ROOT
from .suite_shell import PASSED_REPORT, SuiteShell
from .waiting import until


@pytest.fixture
def shell(tmp_path: Path) -> SuiteShell:
    return SuiteShell(tmp_path)


def test_maven_runs_one_module_with_a_jvm_per_worker(shell: SuiteShell) -> None:
    shell.maven(0, PASSED_REPORT)
    shell.results("suite_java tests", workers=2)
    asked = (shell.folder / "asked").read_text()
    assert "-T 1 -DforkCount=2 " in asked and asked.endswith(" test\n")


def test_maven_compiles_with_one_worker_beside_another_lane(shell: SuiteShell) -> None:
    shell.maven(0, None)
    shell.results("suite_java_build", workers=2)
    assert "-T 1 " in (shell.folder / "asked").read_text()
    shell.results("suite_java_build", workers=8)
    assert "-T 7 " in (shell.folder / "asked").read_text()


def test_worker_count_is_set_in_one_place() -> None:
    # Not of folders that Maven makes and removes meanwhile.
    poms = [*ROOT.glob("pom.xml"), *ROOT.glob("*/pom.xml"), *ROOT.glob("*/*/pom.xml")]
    assert len(poms) > 5
    for pom in poms:
        assert "forkCount" not in pom.read_text(), pom
    for project in ("bench", "e2e", "ros-bridge", "scripts", "sdk-python", "signing-relay"):
        settings = tomllib.loads((ROOT / project / "pyproject.toml").read_text())
        options = settings["tool"]["pytest"]["ini_options"]["addopts"]
        assert not re.search(r"-n (?!auto)", options), project


def test_worker_count_is_core_count_or_setting(shell: SuiteShell) -> None:
    commands = "count_workers; echo $WORKERS $PYTEST_XDIST_AUTO_NUM_WORKERS"
    assert shell.run("nproc() { echo 3; }", commands).stdout == "3 3\n"
    assert shell.run("DRONEMAP_TEST_WORKERS=05", commands).stdout == "5 5\n"


@pytest.mark.parametrize("workers", ["0", "257", "two", "-1"])
def test_invalid_worker_count_is_refused(shell: SuiteShell, workers: str) -> None:
    outcome = shell.run(f"DRONEMAP_TEST_WORKERS={workers}", "count_workers")
    assert outcome.returncode == 2
    assert f"DRONEMAP_TEST_WORKERS is '{workers}'; it must be a number from 1 to 256" in outcome.stderr


# A pipe opens for whoever writes into it when somebody reads it: at the same time or never.
MEETING = (
    "mkfifo $ROOT/door",
    'meets() { timeout 25 bash -c ": $1 $ROOT/door"; }',
    "one() { check main meets meets '<'; }",
    "other() { check side meets meets '>'; }",
)


def test_two_lanes_run_at_the_same_time(shell: SuiteShell) -> None:
    found = shell.results(*MEETING, "side_by_side one other", "record after passed both")
    assert sorted(found[:2]) == ["main passed", "side passed"]
    assert found[2] == "after passed"


def test_with_one_worker_lanes_run_one_after_the_other(shell: SuiteShell) -> None:
    """In one process, which can only do one thing after the other."""
    alone = (
        "busy() { mkdir $ROOT/busy && rmdir $ROOT/busy; }",
        "one() { echo $BASHPID >>$ROOT/processes; check main alone busy; }",
        "other() { echo $BASHPID >>$ROOT/processes; check side alone busy; }",
    )
    assert shell.results(*alone, "side_by_side one other", workers=1) == ["side passed", "main passed"]
    first, second = (shell.folder / "processes").read_text().split()
    assert first == second


def test_a_lane_that_ends_early_is_a_failure(shell: SuiteShell) -> None:
    found = shell.results("one() { check main good true; }", "other() { exit 3; }", "side_by_side one other")
    assert sorted(found) == ["lanes failed", "main passed"]


def test_output_of_two_failed_checks_is_not_mixed(shell: SuiteShell) -> None:
    """They fail at the same time; the first to speak goes on when the other one wants to speak as well."""
    outcome = shell.run(
        *MEETING[:2],
        "fails() { meets $1; false; }",
        "flock() { touch $ROOT/wants-$BASHPID; command flock $1; }",
        "both_want() { set -- $ROOT/wants-*; (($# == 2)); }",
        "rest() { until both_want; do sleep 0.01; done; for n in {2..10}; do echo said of $1; done; }",
        "tail() { echo said of $3; rest $3; }",
        "one() { check main bad fails '<'; }",
        "other() { check side bad fails '>'; }",
        "side_by_side one other",
    )
    output = re.findall(r"^(?:==> |    said of \S+/)(main|side)", outcome.stdout, re.MULTILINE)
    assert output in (["main"] * 11 + ["side"] * 11, ["side"] * 11 + ["main"] * 11)


def test_an_interruption_ends_both_lanes(shell: SuiteShell) -> None:
    pids = shell.folder / "pids"
    waits = f"waits() {{ echo $BASHPID >>{pids}; sleep 100; }}"
    lanes = (
        "one() { check main long waits; }",
        "other() { check side long waits; }",
        "side_by_side one other",
    )
    with subprocess.Popen(
        shell.command_line(waits, *lanes), env=shell.environment(), stderr=subprocess.PIPE, text=True
    ) as run:
        until("both have begun", lambda: pids.exists() and len(pids.read_text().split()) == 2)
        run.send_signal(signal.SIGTERM)
        output = run.communicate(timeout=30)[1]
    assert run.returncode == 143
    assert output.count("Interrupted while testing") == 1
    for pid in pids.read_text().split():
        assert not Path(f"/proc/{pid}").exists()
