"""Patterns and rounds of `./dronemap test --only` and `--repeat`."""

from pathlib import Path

import pytest

from .suite_shell import PASSED_REPORT, SuiteShell


@pytest.fixture
def shell(tmp_path: Path) -> SuiteShell:
    return SuiteShell(tmp_path)


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
    shell: SuiteShell, pattern: str, title: str, wanted: bool
) -> None:
    outcome = shell.run(f"choose_tests test --only '{pattern}'", f"if is_wanted '{title}'; then echo yes; fi")
    assert outcome.returncode == 0, outcome.stderr
    assert outcome.stdout == ("yes\n" if wanted else "")


def test_without_a_pattern_all_checks_run(shell: SuiteShell) -> None:
    assert shell.results("choose_tests test", "check shell good true") == ["shell passed"]


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
def test_invalid_options_are_refused(shell: SuiteShell, options: str, sentence: str) -> None:
    outcome = shell.run(f"choose_tests test {options}")
    assert outcome.returncode == 2
    assert sentence in outcome.stderr


def test_rounds_continue_after_failure_and_report_it(shell: SuiteShell) -> None:
    """The second of three fails."""
    found = shell.results(
        "choose_tests test --repeat 3 good",
        "plan_tests() { :; }",
        "run_round() { check shell good test ${TEST_LOGS: -1} != 2; }",
        "run_rounds test",
    )
    assert found == ["shell passed", "shell failed", "shell passed"]


def test_pattern_without_match_is_refused(shell: SuiteShell) -> None:
    outcome = shell.run(
        "choose_tests test --only nothing",
        "plan_tests() { :; }",
        "run_round() { check shell good true; }",
        "run_rounds test",
    )
    assert outcome.returncode == 2
    assert "Nothing matches 'nothing' (in test)" in outcome.stderr


def plan(shell: SuiteShell, *lines: str) -> str:
    file = shell.folder / "plan.tsv"
    file.write_text("".join(f"{line}\n" for line in lines))
    return f"PLAN={file}"


def test_languages_without_match_are_not_started(shell: SuiteShell) -> None:
    pytest_alone = plan(
        shell, "pytest\te2e\ttests/test_a.py::test_b", "pytest\te2e\ttests/test_a.py::test_c[1]"
    )
    found = shell.run(
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
    assert not (shell.folder / "asked").exists()


def test_java_round_names_modules_and_classes(shell: SuiteShell) -> None:
    shell.maven(0, PASSED_REPORT)
    lines = ("java\tdronemap-a\ta.A", "java\tdronemap-b\tb.B#one+two", "java\tdronemap-a\ta.C")
    assert shell.results(plan(shell, *lines), "round_of_java soak") == ["java junit"]
    asked = (shell.folder / "asked").read_text()
    assert "-pl dronemap-a,dronemap-b -am -Dtest=a.A,b.B#one+two,a.C " in asked
    assert "-Dgroups=soak" in asked and "-Parchive" in asked


def test_whole_files_run_apart_from_single_tests(shell: SuiteShell) -> None:
    npm = shell.folder / "bin" / "npm"
    npm.write_text(f'#!/bin/sh\necho "$@" >>{shell.folder}/asked\n')
    npm.chmod(0o755)
    (shell.folder / "web-client").mkdir()
    lines = (
        "vitest\tweb-client\tsrc/a.test.ts\t",
        "vitest\tweb-client\tsrc/b.test.ts\tgroup one",
        "vitest\tweb-client\tsrc/b.test.ts\tgroup two",
    )
    found = shell.results(plan(shell, *lines), "round_of_vitest")
    assert found == ["typescript junit", "typescript named"]
    asked = (shell.folder / "asked").read_text().splitlines()
    assert asked[0].endswith("vitest-web-client-files.xml src/a.test.ts")
    assert asked[1].endswith(
        "vitest-web-client-names.xml src/b.test.ts --testNamePattern ^(group one|group two)$"
    )


def test_only_server_script_tests_need_jars(shell: SuiteShell) -> None:
    tests = shell.folder / "scripts" / "tests"
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
        assert shell.run(plan(shell, line), asked).stdout == f"{expected}\n"
