"""How `./dronemap test` runs a suite: nothing that failed may end as a line of success in the table."""

import ast
import os
import re
import signal
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from .conftest import ROOT
from .waiting import until

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
        program.write_text(f'#!/bin/sh\necho "$@" >{self.folder}/asked\n{written}exit {status}\n')
        program.chmod(0o755)

    def words(self, *commands: str, workers: int = 2) -> list[str]:
        """What has a shell run commands with the script's functions at hand."""
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
            self.words(*commands, workers=workers),
            env=self.environment(),
            text=True,
            capture_output=True,
            check=False,
            timeout=60,
        )

    def results(self, *commands: str, workers: int = 2) -> list[str]:
        """What the commands write down, as `report.py` reads it, without the paths of logs and reports."""
        outcome = self.run(*commands, workers=workers)
        assert outcome.returncode == 0, outcome.stderr
        lines = (self.folder / "results.tsv").read_text().splitlines()
        return [" ".join(line.split("\t")[:2]) for line in lines]


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    return Bench(tmp_path)


def test_check_result_is_recorded(bench: Bench) -> None:
    assert bench.results("check shell good true", "check shell bad false") == ["shell passed", "shell failed"]


def test_failed_suite_is_recorded_beside_its_reports(bench: Bench) -> None:
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
def test_failed_java_test_fails_the_suite(
    bench: Bench, status: int, report: str | None, expected: list[str]
) -> None:
    bench.maven(status, report)
    assert bench.results("suite_java test") == expected


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
        "suite_python_checks",
        'suite_pytest "not soak" needs_no_jars',
        'suite_scripts without_jars -n "$(workers_beside)"',
    ]
    assert called_by("command_test")[-1] == called_by("command_soak")[-1] == "report"
    assert (ROOT / ".ci" / "run").read_text().splitlines()[-1] == "exec ./dronemap test"


def test_each_python_project_runs_in_one_half(bench: Bench) -> None:
    for project in ("ros-bridge", "new"):
        (bench.folder / project).mkdir()
        (bench.folder / project / "pyproject.toml").touch()
    run = "run_pytest() { record $1 passed x; }"
    assert bench.results(run, "suite_pytest soak needs_no_jars") == ["ros-bridge passed"]
    assert bench.results(run, "suite_pytest soak needs_jars") == ["ros-bridge passed", "new passed"]


def test_statuses_of_earlier_runs_do_not_count(bench: Bench) -> None:
    """Its folder is empty at first: a folder that is there already ends the run."""
    whole = ("begin_statuses", "echo $DRONEMAP_SEEN_STATUSES; ls $DRONEMAP_SEEN_STATUSES")
    assert bench.run(*whole).stdout == f"{bench.folder}/test/seen-statuses\n"
    assert bench.run(*whole).returncode != 0


@pytest.mark.parametrize(("seen", "expected"), [("200", "passed"), ("404", "failed")])
def test_unseen_listed_status_fails_whole_run(bench: Bench, seen: str, expected: str) -> None:
    tests = bench.folder / "dronemap-ws" / "src" / "test" / "resources"
    (tests / "wire").mkdir(parents=True)
    (tests / "wire" / "openapi.json").write_text('{"paths": {"/a": {"get": {"responses": {"200": {}}}}}}')
    (tests / "unseen-statuses.txt").touch()
    (bench.folder / "scripts").symlink_to(ROOT / "scripts")
    sees = f"echo GET /a {seen} >$DRONEMAP_SEEN_STATUSES/1.txt"
    python = f"PYTHON={Path(sys.executable).parent}"
    assert bench.results(python, "begin_statuses", sees, "suite_statuses") == [f"statuses {expected}"]


def asks_for_jars(file: Path) -> bool:
    """By what its tests are given, and by what it imports."""
    given, imported = set(), set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.FunctionDef):
            given |= {argument.arg for argument in node.args.args}
        elif isinstance(node, ast.Import):
            imported |= {each.name for each in node.names}
    return bool(given & {"built", "with_jars"}) or "bill_of_materials" in imported


def test_each_script_test_file_runs_in_one_half(bench: Bench) -> None:
    (bench.folder / "scripts").symlink_to(ROOT / "scripts")
    run = 'run_pytest() { printf "%s\\n" "${@:4}"; }'
    files = sorted((ROOT / "scripts").glob("tests/test_*.py"))
    with_jars = [f"tests/{file.name}" for file in files if asks_for_jars(file)]
    assert 0 < len(with_jars) < len(files)
    assert bench.run(run, "suite_scripts with_jars").stdout.split() == with_jars
    ignored = [f"--ignore={name}" for name in with_jars]
    assert bench.run(run, "suite_scripts without_jars -n 1").stdout.split() == ["-n", "1", *ignored]


def test_two_halves_of_a_project_leave_two_reports(bench: Bench) -> None:
    (bench.folder / "scripts" / "tests").mkdir(parents=True)
    (bench.folder / "scripts" / "tests" / "test_a.py").write_text("import bill_of_materials")
    bench.results("PYTHON=/bin", "suite_scripts with_jars", "suite_scripts without_jars")
    lines = [line.split("\t") for line in (bench.folder / "results.tsv").read_text().splitlines()]
    reports = [what for _, kind, what, _ in lines if kind == "junit"]
    logs = {log for *_, log in lines}
    assert len(reports) == len(set(reports)) == len(logs) == 2


# --- workers and lanes ---


def test_maven_runs_one_module_with_a_jvm_per_worker(bench: Bench) -> None:
    bench.maven(0, PASSED_REPORT)
    bench.results("suite_java tests", workers=2)
    asked = (bench.folder / "asked").read_text()
    assert "-T 1 -DforkCount=2 " in asked and asked.endswith(" test\n")


def test_maven_compiles_with_one_worker_beside_another_lane(bench: Bench) -> None:
    bench.maven(0, None)
    bench.results("suite_java_build", workers=2)
    assert "-T 1 " in (bench.folder / "asked").read_text()
    bench.results("suite_java_build", workers=8)
    assert "-T 7 " in (bench.folder / "asked").read_text()


def test_worker_count_is_set_in_one_place() -> None:
    # Not of folders that Maven makes and removes meanwhile.
    poms = [*ROOT.glob("pom.xml"), *ROOT.glob("*/pom.xml"), *ROOT.glob("*/*/pom.xml")]
    assert len(poms) > 5
    for pom in poms:
        assert "forkCount" not in pom.read_text(), pom
    for project in ("bench", "e2e", "ros-bridge", "scripts", "sdk-python"):
        settings = tomllib.loads((ROOT / project / "pyproject.toml").read_text())
        options = settings["tool"]["pytest"]["ini_options"]["addopts"]
        assert not re.search(r"-n (?!auto)", options), project


def test_worker_count_is_core_count_or_setting(bench: Bench) -> None:
    told = "count_workers; echo $WORKERS $PYTEST_XDIST_AUTO_NUM_WORKERS"
    assert bench.run("nproc() { echo 3; }", told).stdout == "3 3\n"
    assert bench.run("DRONEMAP_TEST_WORKERS=05", told).stdout == "5 5\n"


@pytest.mark.parametrize("workers", ["0", "257", "two", "-1"])
def test_invalid_worker_count_is_refused(bench: Bench, workers: str) -> None:
    outcome = bench.run(f"DRONEMAP_TEST_WORKERS={workers}", "count_workers")
    assert outcome.returncode == 2
    assert f"DRONEMAP_TEST_WORKERS is '{workers}'; it must be a number from 1 to 256" in outcome.stderr


# A pipe opens for whoever writes into it when somebody reads it: at the same time or never.
MEETING = (
    "mkfifo $ROOT/door",
    'meets() { timeout 25 bash -c ": $1 $ROOT/door"; }',
    "one() { check main meets meets '<'; }",
    "other() { check side meets meets '>'; }",
)


def test_two_lanes_run_at_the_same_time(bench: Bench) -> None:
    found = bench.results(*MEETING, "side_by_side one other", "record after passed both")
    assert sorted(found[:2]) == ["main passed", "side passed"]
    assert found[2] == "after passed"


def test_with_one_worker_lanes_run_one_after_the_other(bench: Bench) -> None:
    """In one process, which can only do one thing after the other."""
    alone = (
        "busy() { mkdir $ROOT/busy && rmdir $ROOT/busy; }",
        "one() { echo $BASHPID >>$ROOT/processes; check main alone busy; }",
        "other() { echo $BASHPID >>$ROOT/processes; check side alone busy; }",
    )
    assert bench.results(*alone, "side_by_side one other", workers=1) == ["side passed", "main passed"]
    first, second = (bench.folder / "processes").read_text().split()
    assert first == second


def test_a_lane_that_ends_early_is_a_failure(bench: Bench) -> None:
    found = bench.results("one() { check main good true; }", "other() { exit 3; }", "side_by_side one other")
    assert sorted(found) == ["lanes failed", "main passed"]


def test_output_of_two_failed_checks_is_not_mixed(bench: Bench) -> None:
    """They fail at the same time; the first to speak goes on when the other one wants to speak as well."""
    outcome = bench.run(
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
    said = re.findall(r"^(?:==> |    said of \S+/)(main|side)", outcome.stdout, re.MULTILINE)
    assert said in (["main"] * 11 + ["side"] * 11, ["side"] * 11 + ["main"] * 11)


def test_an_interruption_ends_both_lanes(bench: Bench) -> None:
    pids = bench.folder / "pids"
    waits = f"waits() {{ echo $BASHPID >>{pids}; sleep 100; }}"
    lanes = (
        "one() { check main long waits; }",
        "other() { check side long waits; }",
        "side_by_side one other",
    )
    with subprocess.Popen(
        bench.words(waits, *lanes), env=bench.environment(), stderr=subprocess.PIPE, text=True
    ) as run:
        until("both have begun", lambda: pids.exists() and len(pids.read_text().split()) == 2)
        run.send_signal(signal.SIGTERM)
        said = run.communicate(timeout=30)[1]
    assert run.returncode == 143
    assert said.count("Interrupted while testing") == 1
    for pid in pids.read_text().split():
        assert not Path(f"/proc/{pid}").exists()


# --- patterns and rounds ---


@pytest.mark.parametrize(
    ("pattern", "title", "wanted"),
    [
        ("ruff e2e", "python: ruff e2e", True),
        ("r*f e2", "python: ruff e2e", True),
        ("Ruff", "python: ruff e2e", False),
        ("r?ff", "python: ruff e2e", False),
        ("[pr]", "python: ruff e2e", False),
        ("(a) [b] c\\?", "x: (a) [b] c\\?", True),
        ("e2e*ruff", "python: ruff e2e", False),
    ],
)
def test_pattern_matches_part_of_name_with_stars(
    bench: Bench, pattern: str, title: str, wanted: bool
) -> None:
    outcome = bench.run(f"choose_tests test --only '{pattern}'", f"if is_wanted '{title}'; then echo yes; fi")
    assert outcome.returncode == 0, outcome.stderr
    assert outcome.stdout == ("yes\n" if wanted else "")


def test_without_a_pattern_all_checks_run(bench: Bench) -> None:
    assert bench.results("choose_tests test", "check shell good true") == ["shell passed"]


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ("--repeat 0 x", "--repeat is '0'; it must be a number from 1 to 1000"),
        ("--repeat 1001 x", "--repeat is '1001'; it must be a number from 1 to 1000"),
        ("--repeat often x", "--repeat is 'often'; it must be a number from 1 to 1000"),
        ("--repeat -1 x", "--repeat is '-1'; it must be a number from 1 to 1000"),
        ("--repeat", "--repeat is ''; it must be a number from 1 to 1000"),
        ("--repeat 2", "--repeat needs a number and one pattern"),
        ("--repeat 2 a b", "--repeat needs a number and one pattern"),
        ("--only", "--only needs one pattern"),
        ("--only a b", "--only needs one pattern"),
        ("--only ''", "The pattern '' names nothing"),
        ("--only '* *'", "The pattern '* *' names nothing"),
        ("--loud", "test does not know '--loud'"),
    ],
)
def test_invalid_options_are_refused(bench: Bench, options: str, sentence: str) -> None:
    outcome = bench.run(f"choose_tests test {options}")
    assert outcome.returncode == 2
    assert sentence in outcome.stderr


def test_rounds_continue_after_failure_and_report_it(bench: Bench) -> None:
    """The second of three fails."""
    found = bench.results(
        "choose_tests test --repeat 3 good",
        "plan_tests() { :; }",
        "run_round() { check shell good test ${TEST_LOGS: -1} != 2; }",
        "run_rounds test",
    )
    assert found == ["shell passed", "shell failed", "shell passed"]


def test_pattern_without_match_is_refused(bench: Bench) -> None:
    outcome = bench.run(
        "choose_tests test --only nothing",
        "plan_tests() { :; }",
        "run_round() { check shell good true; }",
        "run_rounds test",
    )
    assert outcome.returncode == 2
    assert "Nothing matches 'nothing' (in test)" in outcome.stderr


def plan(bench: Bench, *lines: str) -> str:
    file = bench.folder / "plan.tsv"
    file.write_text("".join(f"{line}\n" for line in lines))
    return f"PLAN={file}"


def test_languages_without_match_are_not_started(bench: Bench) -> None:
    pytest_alone = plan(
        bench, "pytest\te2e\ttests/test_a.py::test_b", "pytest\te2e\ttests/test_a.py::test_c[1]"
    )
    found = bench.run(
        pytest_alone,
        "choose_tests test --only test_b",
        'run_pytest() { echo "$@"; }',
        "python_projects() { echo e2e; }",
        "PYTHON=/nowhere",
        "mkdir -p $ROOT/scripts $ROOT/docker $ROOT/.ci && touch $ROOT/dronemap $ROOT/.ci/run",
        "run_round test",
    )
    assert found.returncode == 0, found.stderr
    assert found.stdout == "e2e -n 0 -m not soak tests/test_a.py::test_b tests/test_a.py::test_c[1]\n"
    assert not (bench.folder / "asked").exists()


def test_java_round_names_modules_and_classes(bench: Bench) -> None:
    bench.maven(0, PASSED_REPORT)
    lines = ("java\tdronemap-a\ta.A", "java\tdronemap-b\tb.B#one+two", "java\tdronemap-a\ta.C")
    assert bench.results(plan(bench, *lines), "round_of_java soak") == ["java junit"]
    asked = (bench.folder / "asked").read_text()
    assert "-pl dronemap-a,dronemap-b -am -Dtest=a.A,b.B#one+two,a.C " in asked
    assert "-Dgroups=soak" in asked and "-Parchive" in asked


def test_whole_files_run_apart_from_single_tests(bench: Bench) -> None:
    npm = bench.folder / "bin" / "npm"
    npm.write_text(f'#!/bin/sh\necho "$@" >>{bench.folder}/asked\n')
    npm.chmod(0o755)
    (bench.folder / "web-client").mkdir()
    lines = (
        "vitest\tsrc/a.test.ts\t",
        "vitest\tsrc/b.test.ts\tgroup one",
        "vitest\tsrc/b.test.ts\tgroup two",
    )
    found = bench.results(plan(bench, *lines), "round_of_vitest")
    assert found == ["typescript junit", "typescript named"]
    asked = (bench.folder / "asked").read_text().splitlines()
    assert asked[0].endswith("vitest-files.xml src/a.test.ts")
    assert asked[1].endswith("vitest-names.xml src/b.test.ts --testNamePattern ^(group one|group two)$")


def test_only_server_script_tests_need_jars(bench: Bench) -> None:
    tests = bench.folder / "scripts" / "tests"
    tests.mkdir(parents=True)
    (tests / "test_server.py").write_text("def test_up(built: Checkout) -> None: ...")
    (tests / "test_table.py").write_text("def test_counts() -> None: ...")
    (tests / "test_list.py").write_text("import bill_of_materials")
    asked = "if any_needs_jars; then echo jars; else echo none; fi"
    for line, expected in [
        ("pytest\tscripts\ttests/test_table.py::test_counts", "none"),
        ("pytest\tscripts\ttests/test_server.py::test_up", "jars"),
        ("pytest\tscripts\ttests/test_list.py::test_names", "jars"),
        ("pytest\te2e\ttests/test_a.py::test_b", "jars"),
        ("pytest\tsdk-python\ttests/test_a.py::test_b", "none"),
    ]:
        assert bench.run(plan(bench, line), asked).stdout == f"{expected}\n"
