"""The table that ends a test run: what it counts, what it calls not proved, when it fails."""

from pathlib import Path

import pytest

import report

JUNIT = """<testsuites><testsuite tests="4">
  <testcase classname="A" name="flies"/>
  <testcase classname="A" name="lands"><failure message="crashed">at …</failure></testcase>
  <testcase classname="A" name="dives"><error message="no water"/></testcase>
  <testcase classname="A" name="sails"><skipped message="Assumption failed: no lake here"/></testcase>
</testsuite></testsuites>"""


def results(folder: Path, *lines: tuple[str, str, str, str]) -> list[str]:
    file = folder / "results.tsv"
    file.write_text("".join("\t".join(line) + "\n" for line in lines))
    return [str(file)]


def test_counts_every_case_of_a_report(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "TEST-a.xml").write_text(JUNIT)
    code = report.main(results(tmp_path, ("java", "junit", f"{tmp_path}/TEST-*.xml", "log")))
    printed = capsys.readouterr().out
    assert code == 1
    assert printed.splitlines()[-1] == "1 passed, 2 failed, 1 skipped"
    assert "not proved: no lake here" in printed
    assert "FAILED A lands" in printed


def test_repeats_what_a_failed_test_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    long = "\n".join(f"line {number}" for number in range(100))
    case = f'<testcase classname="B" name="turns"><failure message="m">{long}</failure></testcase>'
    (tmp_path / "TEST-a.xml").write_text(JUNIT.replace("</testsuite>", f"{case}</testsuite>"))
    report.main(results(tmp_path, ("java", "junit", f"{tmp_path}/TEST-*.xml", "log")))
    lines = capsys.readouterr().out.splitlines()
    assert lines[lines.index("FAILED A lands") + 1] == "    at …"
    assert lines[lines.index("FAILED A dives") + 1] == "    no water"
    said = lines[lines.index("FAILED B turns") + 1 :]
    assert said[0] == "    line 0" and "    line 99" in said and "    line 50" not in said


def test_says_what_adapters_were_tried_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = "<system-out>12:00 noise\ntried on: PostgresTest, PostgreSQL 18.3\n</system-out>"
    (tmp_path / "TEST-a.xml").write_text(f'<testsuite><testcase name="a">{output}</testcase></testsuite>')
    report.main(results(tmp_path, ("java", "junit", f"{tmp_path}/TEST-*.xml", "log")))
    assert "tried on: PostgresTest, PostgreSQL 18.3" in capsys.readouterr().out.splitlines()


def test_passes_when_all_passed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert report.main(results(tmp_path, ("shell", "passed", "shellcheck", ""))) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "1 passed, 0 failed, 0 skipped"


def test_what_could_not_be_checked_is_called_not_proved(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = (("shell", "passed", "shellcheck", ""), ("supply", "skipped", "no database", ""))
    assert report.main(results(tmp_path, *lines)) == 0
    printed = capsys.readouterr().out
    assert "not proved: no database" in printed
    assert printed.splitlines()[-1] == "1 passed, 0 failed, 1 skipped"


def test_a_suite_that_ended_without_a_report_has_failed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = (
        ("java", "junit", f"{tmp_path}/TEST-*.xml", "java.log"),
        ("java", "status", "verify", "java.log"),
        ("shell", "passed", "shellcheck", ""),
    )
    assert report.main(results(tmp_path, *lines)) == 1
    printed = capsys.readouterr().out
    assert "verify ended with an error outside any test (see java.log)" in printed
    assert printed.splitlines()[-1] == "1 passed, 1 failed, 0 skipped"


def test_an_error_is_not_counted_twice(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "TEST-a.xml").write_text(JUNIT)
    lines = (("java", "junit", f"{tmp_path}/TEST-*.xml", "log"), ("java", "status", "verify", "log"))
    assert report.main(results(tmp_path, *lines)) == 1
    assert capsys.readouterr().out.splitlines()[-1] == "1 passed, 2 failed, 1 skipped"


def test_a_broken_report_is_a_failure(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "TEST-a.xml").write_text("<testsuite><testcase")
    assert report.main(results(tmp_path, ("java", "junit", f"{tmp_path}/TEST-*.xml", "log"))) == 1
    assert "is not readable" in capsys.readouterr().out


def test_a_run_without_any_test_has_failed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert report.main(results(tmp_path)) == 1
    assert capsys.readouterr().out.splitlines()[-1] == "0 passed, 0 failed, 0 skipped"
