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


def test_failure_messages_are_printed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    long = "\n".join(f"line {number}" for number in range(100))
    case = f'<testcase classname="B" name="turns"><failure message="m">{long}</failure></testcase>'
    (tmp_path / "TEST-a.xml").write_text(JUNIT.replace("</testsuite>", f"{case}</testsuite>"))
    report.main(results(tmp_path, ("java", "junit", f"{tmp_path}/TEST-*.xml", "log")))
    lines = capsys.readouterr().out.splitlines()
    assert lines[lines.index("FAILED A lands") + 1] == "    at …"
    assert lines[lines.index("FAILED A dives") + 1] == "    no water"
    messages = lines[lines.index("FAILED B turns") + 1 :]
    assert messages[0] == "    line 0" and "    line 99" in messages and "    line 50" not in messages


def test_adapter_versions_are_printed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = "<system-out>12:00 noise\ntried on: PostgresTest, PostgreSQL 18.3\n</system-out>"
    (tmp_path / "TEST-a.xml").write_text(f'<testsuite><testcase name="a">{output}</testcase></testsuite>')
    report.main(results(tmp_path, ("java", "junit", f"{tmp_path}/TEST-*.xml", "log")))
    assert "tried on: PostgresTest, PostgreSQL 18.3" in capsys.readouterr().out.splitlines()


def test_passes_when_all_passed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert report.main(results(tmp_path, ("shell", "passed", "shellcheck", ""))) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "1 passed, 0 failed, 0 skipped"


def test_unchecked_suites_are_not_proved(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
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


def case(name: str, seconds: float = 0, inside: str = "", group: str = "A") -> str:
    return f'<testcase classname="{group}" name="{name}" time="{seconds}">{inside}</testcase>'


def test_names_the_slowest_over_all_suites(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    java = "".join(case(f"flies{number}", number) for number in range(8))
    (tmp_path / "java.xml").write_text(f"<testsuite>{java}</testsuite>")
    (tmp_path / "web.xml").write_text(f"<testsuite>{case('draws', 3.5)}{case('is quick', 0.01)}</testsuite>")
    (tmp_path / "e2e.xml").write_text(f"<testsuite>{case('lands', 100)}{case('waits', 2.25)}</testsuite>")
    lines = [(name, "junit", f"{tmp_path}/{name}.xml", name) for name in ("java", "web", "e2e")]
    assert report.main(results(tmp_path, *lines)) == 0
    printed = capsys.readouterr().out.splitlines()
    slowest = printed[printed.index("The 10 slowest:") + 1 :][:11]
    assert slowest[0] == "    100.0 s  e2e: A lands"
    assert slowest[1] == "      7.0 s  java: A flies7"
    assert "      3.5 s  web: A draws" in slowest
    assert slowest[9] == "      1.0 s  java: A flies1"
    assert slowest[10] == ""


def test_class_setup_time_counts_among_slowest(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a.xml").write_text(f'<testsuite name="A" time="30.5">{case("one", 1)}</testsuite>')
    (tmp_path / "b.xml").write_text(f'<testsuite name="pytest" time="90">{case("two", 2)}</testsuite>')
    report.main(results(tmp_path, ("java", "junit", f"{tmp_path}/?.xml", "log")))
    printed = capsys.readouterr().out.splitlines()
    assert printed[printed.index("The 3 slowest:") + 1] == "     29.5 s  java: A (beside its tests)"


@pytest.mark.parametrize(
    ("inside", "reason"),
    [
        ('<skipped message="Assumption failed: no lake here"/>', "no lake here"),
        ("<skipped><![CDATA[org.opentest4j.TestAbortedException: no wind]]></skipped>", "no wind"),
        ('<skipped type="pytest.skip" message="no browser">tests/a.py:3: no browser</skipped>', "no browser"),
        ("<skipped/>", "no reason given: A sails"),
    ],
    ids=["assumption of Java", "abortion in Java", "Python", "TypeScript"],
)
def test_skip_reasons_of_each_language_are_printed(
    inside: str, reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "a.xml").write_text(f"<testsuite>{case('sails', 0, inside)}{case('flies')}</testsuite>")
    assert report.main(results(tmp_path, ("any", "junit", f"{tmp_path}/a.xml", "log"))) == 0
    printed = capsys.readouterr().out
    assert f"not proved: {reason}\n" in printed
    assert printed.splitlines()[-1] == "1 passed, 0 failed, 1 skipped"


def test_deselected_tests_are_not_skips(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    left_out = case("sails", 0, "<skipped/>") + case("dives", 0, '<skipped message="no water"/>')
    (tmp_path / "a.xml").write_text(f"<testsuite>{left_out}{case('flies')}</testsuite>")
    report.main(results(tmp_path, ("web", "named", f"{tmp_path}/a.xml", "log")))
    printed = capsys.readouterr().out
    assert "sails" not in printed and "not proved: no water" in printed
    assert printed.splitlines()[-1] == "1 passed, 0 failed, 1 skipped"


def test_failures_per_round_are_printed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    failed, passed = case("lands", 1, '<failure message="crashed"/>'), case("lands", 1)
    for number, landed in enumerate((passed, failed, failed, passed)):
        (tmp_path / f"{number}.xml").write_text(f"<testsuite>{landed}{case('flies', 1)}</testsuite>")
    lines = [("java", "junit", f"{tmp_path}/{number}.xml", f"log{number}") for number in range(4)]
    assert report.main(["--rounds", "4", *results(tmp_path, *lines)]) == 1
    printed = capsys.readouterr().out
    assert "In 4 rounds 1 of 2 tests failed at least once.\n  failed 2 of 4 times: java: A lands\n" in printed
    assert printed.count("FAILED A lands") == 2, "once in the table and once with what it said"
    assert printed.splitlines()[-1] == "6 passed, 2 failed, 0 skipped"


def test_failure_does_not_hide_error_of_another_report(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "TEST-a.xml").write_text(JUNIT)
    lines = (
        ("python", "junit", f"{tmp_path}/TEST-*.xml", "first.log"),
        ("python", "status", "pytest first", "first.log"),
        ("python", "junit", "/no/such.xml", "second.log"),
        ("python", "status", "pytest second", "second.log"),
    )
    assert report.main(results(tmp_path, *lines)) == 1
    printed = capsys.readouterr().out
    assert "pytest second ended with an error outside any test (see second.log)" in printed
    assert "pytest first ended" not in printed


def test_a_run_in_which_nothing_ran_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert report.main(results(tmp_path)) == 1
    assert "Nothing ran." in capsys.readouterr().out.splitlines()
