"""The table of flights of separation: shares of breaches with and without what keeps drones apart."""

from pathlib import Path

import pytest

import separation_table

HEAD = (
    "scenario seed moment mechanism result second pair horizontal vertical share"
    " breaches unserved late factor"
)
FLIGHTS = (
    ("two-runs", "1", "", "off", "breach", "70.1", "a and b", "3.20", "1.00", "0.320", "2", "0", "0", "1.10"),
    ("two-runs", "2", "", "off", "ok", "70.1", "a and b", "11.00", "1.00", "1.100", "0", "0", "0", "1.00"),
    ("two-runs", "1", "", "on", "ok", "71.0", "a and b", "12.50", "0.40", "1.250", "0", "0", "0", "1.31"),
    ("two-runs", "2", "", "on", "late", "", "", "", "", "", "0", "0", "1", "inf"),
    ("pilot", "1", "70.1", "on", "breach", "9.0", "a and b", "9.00", "0.00", "0.900", "1", "0", "0", "0.00"),
    ("pilot", "1", "70.2", "on", "ok", "9.0", "a and b", "0.00", "5.50", "1.100", "0", "0", "0", "0.00"),
)


def test_each_scenario_has_a_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "flights.tsv"
    file.write_text("\n".join("\t".join(row) for row in [HEAD.split(), *FLIGHTS]) + "\n")
    assert separation_table.main([str(file)]) == 0
    head, pilot, runs = [
        [word.strip() for word in line.split("  ") if word.strip()]
        for line in capsys.readouterr().out.splitlines()
    ]
    assert head == list(separation_table.COLUMNS)
    assert pilot == ["pilot", "1", "-", "1 of 2 (50 %)", "-", "9.00 m / 0.00 m", "0", "-"]
    assert runs == [
        *("two-runs", "2", "1 of 2 (50 %)", "0 of 2 (0 %)", "3.20 m / 1.00 m", "12.50 m / 0.40 m"),
        *("1", "not down"),
    ]


def test_other_files_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "other.tsv"
    file.write_text("unit\tresult\n1\tpassed\n")
    assert separation_table.main([str(file)]) == 1
    assert separation_table.main([str(tmp_path / "none.tsv")]) == 1
    assert "other.tsv is not readable" in capsys.readouterr().err
