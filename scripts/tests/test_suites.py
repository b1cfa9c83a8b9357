"""`./dronemap test` records each suite: nothing that failed ends as a success in the table."""

import ast
import sys
from pathlib import Path

import pytest

from .conftest import ROOT
from .suite_shell import PASSED_REPORT, SuiteShell

FAILED_REPORT = '<testsuite><testcase name="lands"><failure message="crashed"/></testcase></testsuite>'
BROKEN_REPORT = '<testsuite><testcase name="lands"><error message="no air"/></testcase></testsuite>'


@pytest.fixture
def shell(tmp_path: Path) -> SuiteShell:
    return SuiteShell(tmp_path)


def test_check_result_is_recorded(shell: SuiteShell) -> None:
    assert shell.results("check shell good true", "check shell bad false") == ["shell passed", "shell failed"]


def test_failed_suite_is_recorded_beside_its_reports(shell: SuiteShell) -> None:
    found = shell.results("counted web units /no/such.xml false", "counted page units /no/such.xml true")
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
def test_failed_java_test_fails_the_suite(
    shell: SuiteShell, status: int, report: str | None, expected: list[str]
) -> None:
    shell.maven(status, report)
    assert shell.results("suite_java test") == expected


def called_by(function: str) -> list[str]:
    text = (ROOT / "scripts" / "lib" / "suites.sh").read_text()
    return [line.strip() for line in text.split(f"\n{function}() {{")[1].split("\n}")[0].splitlines()[1:]]


def test_every_suite_is_part_of_a_test_run() -> None:
    """A suite that nobody calls fails nowhere."""
    assert called_by("test_everything") == [
        "begin_statuses",
        "suite_web_client",
        "side_by_side suite_java_build suite_small",
        'suite_java tests "${AS_BUILT[@]}" -DexcludedGroups=soak',
        'record archive skipped "days of telemetry as Parquet on HDFS, and a crash in the middle:'
        ' ./dronemap soak tests them"',
        "suite_vulnerabilities",
        'suite_pytest "not soak" needs_jars',
        "suite_scripts with_jars",
        "suite_statuses",
    ]
    assert called_by("suite_small") == [
        "suite_shell",
        "suite_typescript",
        "suite_php",
        "suite_python_checks",
        'suite_pytest "not soak" needs_no_jars',
        'suite_scripts without_jars -n "$(workers_beside)"',
    ]
    assert called_by("command_test")[-1] == called_by("command_soak")[-1] == "report"
    assert (ROOT / ".ci" / "run").read_text().splitlines()[-1] == "exec ./dronemap test"


def test_each_python_project_runs_in_one_half(shell: SuiteShell) -> None:
    for project in ("ros-bridge", "new"):
        (shell.folder / project).mkdir()
        (shell.folder / project / "pyproject.toml").touch()
    run = "run_pytest() { record $1 passed x; }"
    assert shell.results(run, "suite_pytest soak needs_no_jars") == ["ros-bridge passed"]
    assert shell.results(run, "suite_pytest soak needs_jars") == ["ros-bridge passed", "new passed"]


def test_statuses_of_earlier_runs_do_not_count(shell: SuiteShell) -> None:
    """Its folder is empty at first: a folder that is there already ends the run."""
    whole = ("begin_statuses", "echo $DRONEMAP_SEEN_STATUSES; ls $DRONEMAP_SEEN_STATUSES")
    assert shell.run(*whole).stdout == f"{shell.folder}/test/seen-statuses\n"
    assert shell.run(*whole).returncode != 0


@pytest.mark.parametrize(("seen", "expected"), [("200", "passed"), ("404", "failed")])
def test_unseen_listed_status_fails_whole_run(shell: SuiteShell, seen: str, expected: str) -> None:
    tests = shell.folder / "dronemap-ws" / "src" / "test" / "resources"
    (tests / "wire").mkdir(parents=True)
    (tests / "wire" / "openapi.json").write_text('{"paths": {"/a": {"get": {"responses": {"200": {}}}}}}')
    (tests / "unseen-statuses.txt").touch()
    (shell.folder / "scripts").symlink_to(ROOT / "scripts")
    sees = f"echo GET /a {seen} >$DRONEMAP_SEEN_STATUSES/1.txt"
    python = f"PYTHON={Path(sys.executable).parent}"
    assert shell.results(python, "begin_statuses", sees, "suite_statuses") == [f"statuses {expected}"]


def asks_for_jars(file: Path) -> bool:
    """By what its tests are given, and by what it imports."""
    given, imported = set(), set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.FunctionDef):
            given |= {argument.arg for argument in node.args.args}
        elif isinstance(node, ast.Import):
            imported |= {each.name for each in node.names}
    return bool(given & {"built", "with_jars"}) or "bill_of_materials" in imported


def test_each_script_test_file_runs_in_one_half(shell: SuiteShell) -> None:
    (shell.folder / "scripts").symlink_to(ROOT / "scripts")
    run = 'run_pytest() { printf "%s\\n" "${@:4}"; }'
    files = sorted((ROOT / "scripts").glob("tests/test_*.py"))
    with_jars = [f"tests/{file.name}" for file in files if asks_for_jars(file)]
    assert 0 < len(with_jars) < len(files)
    assert shell.run(run, "suite_scripts with_jars").stdout.split() == with_jars
    ignored = [f"--ignore={name}" for name in with_jars]
    assert shell.run(run, "suite_scripts without_jars -n 1").stdout.split() == ["-n", "1", *ignored]


def test_two_halves_of_a_project_leave_two_reports(shell: SuiteShell) -> None:
    (shell.folder / "scripts" / "tests").mkdir(parents=True)
    (shell.folder / "scripts" / "tests" / "test_a.py").write_text("import bill_of_materials")
    shell.results("PYTHON=/bin", "suite_scripts with_jars", "suite_scripts without_jars")
    lines = [line.split("\t") for line in (shell.folder / "results.tsv").read_text().splitlines()]
    reports = [what for _, kind, what, _ in lines if kind == "junit"]
    logs = {log for *_, log in lines}
    assert len(reports) == len(set(reports)) == len(logs) == 2


@pytest.mark.parametrize(("installs", "expected"), [(0, "passed"), (1, "failed")])
def test_client_packages_are_installed_once_before_its_checks(
    shell: SuiteShell, installs: int, expected: str
) -> None:
    packages = shell.folder / "sdk-typescript" / "node_modules"
    packages.mkdir(parents=True)
    (packages.parent / "package-lock.json").touch()
    npm = shell.folder / "bin" / "npm"
    npm.write_text(f'#!/bin/sh\necho "$1" >>{shell.folder}/asked\n[ "$1" != ci ] || exit {installs}\n')
    npm.chmod(0o755)
    check = "check typescript x in_typescript sdk-typescript npm run lint"
    assert shell.results(check, check) == [f"typescript {expected}"] * 2
    asked = (shell.folder / "asked").read_text().split()
    assert asked == (["ci", "run", "run"] if installs == 0 else ["ci", "ci"])
