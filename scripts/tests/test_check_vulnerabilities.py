"""An answer counts only from a scanner that shows that it knows what everybody knows."""

import json
import os
import time
from pathlib import Path

import pytest

import bill_of_materials
import check_vulnerabilities
from check_vulnerabilities import KNOWN, NOT_CHECKED, NOTHING_KNOWN, PLANTED

SCANNER = """#!/usr/bin/env python3
# Finds in the bill that it is given what its database lists.
import json, os, sys, pathlib
folder = pathlib.Path(os.environ["OSV_SCANNER_LOCAL_DB_CACHE_DIRECTORY"])
if "--download-offline-databases" in sys.argv and "NETWORK" in os.environ:
    (folder / "all.zip").write_text(os.environ["NETWORK"])
file = folder / "all.zip"
if not file.exists():
    print("could not load db", file=sys.stderr)
known = json.loads(file.read_text()) if file.exists() else []
bill = json.loads(pathlib.Path(sys.argv[sys.argv.index("--lockfile") + 1]).read_text())
packages = [
    {"package": {"name": each["name"] if "group" not in each else each["group"] + ":" + each["name"],
                 "version": each["version"], "ecosystem": "any"},
     "vulnerabilities": [{"id": "GHSA-1"}]}
    for each in bill["components"] if each["purl"] in known
]
print(json.dumps({"results": [{"packages": packages}] if packages else []}))
sys.exit(1 if packages else 127)
"""
EVERYBODY_KNOWS = list(PLANTED.values())


@pytest.fixture
def advisories(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    program = tmp_path / "osv-scanner"
    program.write_text(SCANNER)
    program.chmod(0o755)
    folder = tmp_path / "advisories"
    folder.mkdir()
    monkeypatch.setenv("OSV_SCANNER", str(program))
    monkeypatch.setenv("DRONEMAP_ADVISORIES", str(folder))
    return folder


def shipped() -> str:
    purl: str = bill_of_materials.bill()["components"][0]["purl"]
    return purl


def test_finds_nothing_where_only_what_was_planted_is_known(
    advisories: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (advisories / "all.zip").write_text(json.dumps(EVERYBODY_KNOWS))
    count = len(bill_of_materials.bill()["components"])
    assert check_vulnerabilities.main(["--offline"]) == NOTHING_KNOWN
    assert capsys.readouterr().out == f"Of {count} libraries and packages none has a known vulnerability.\n"


def test_names_what_ships_and_is_known(advisories: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (advisories / "all.zip").write_text(json.dumps([*EVERYBODY_KNOWS, shipped()]))
    assert check_vulnerabilities.main(["--offline"]) == KNOWN
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].endswith(": GHSA-1")
    assert lines[1].startswith("1 of ")
    assert len(lines) == 2


@pytest.mark.parametrize(
    "database",
    [None, [], EVERYBODY_KNOWS[:1], EVERYBODY_KNOWS[1:]],
    ids=["none", "empty", "of libraries only", "of packages only"],
)
def test_says_not_checked_for_a_database_that_misses_what_everybody_knows(
    advisories: Path, capsys: pytest.CaptureFixture[str], database: list[str] | None
) -> None:
    if database is not None:
        (advisories / "all.zip").write_text(json.dumps(database))
    assert check_vulnerabilities.main(["--offline"]) == NOT_CHECKED
    assert "were not checked: the scanner does not know that" in capsys.readouterr().out


def test_says_not_checked_for_an_old_database(advisories: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = advisories / "all.zip"
    file.write_text(json.dumps(EVERYBODY_KNOWS))
    long_ago = time.time() - 40 * 86_400
    os.utime(file, (long_ago, long_ago))
    assert check_vulnerabilities.main(["--offline"]) == NOT_CHECKED
    assert "is 40 days old" in capsys.readouterr().out


def test_fetches_a_database_unless_told_not_to(advisories: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NETWORK", json.dumps(EVERYBODY_KNOWS))
    assert check_vulnerabilities.main(["--offline"]) == NOT_CHECKED
    assert check_vulnerabilities.main([]) == NOTHING_KNOWN
    assert check_vulnerabilities.main(["--offline"]) == NOTHING_KNOWN


@pytest.mark.parametrize("answer", ["", "{}", "[]"], ids=["silence", "no results", "something else"])
def test_says_not_checked_when_the_scanner_tells_nothing(
    advisories: Path, tmp_path: Path, answer: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "osv-scanner").write_text(f"#!/bin/sh\necho '{answer}'\n")
    assert check_vulnerabilities.main(["--offline"]) == NOT_CHECKED
    assert "the scanner ended with 0 and told nothing" in capsys.readouterr().out


def test_says_not_checked_without_a_scanner(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("OSV_SCANNER", "/no/such/program")
    assert check_vulnerabilities.main([]) == NOT_CHECKED
    assert "osv-scanner (version 2) is not installed" in capsys.readouterr().out
