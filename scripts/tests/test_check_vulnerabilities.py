"""An answer counts only from a scanner that shows that it knows what everybody knows, kind by kind."""

import json
import os
import re
import time
from pathlib import Path
from typing import Any

import pytest

import bill_of_materials
import check_vulnerabilities
from check_vulnerabilities import ECOSYSTEMS, KNOWN, NOT_CHECKED, NOTHING_KNOWN, SECURITY_PAGE, Ecosystem

SCANNER = """#!/usr/bin/env python3
# Finds in the bill that it is given what the databases of its kinds list.
import json, os, sys, pathlib
folder = pathlib.Path(os.environ["OSV_SCANNER_LOCAL_DB_CACHE_DIRECTORY"]) / "osv-scanner"
bill = json.loads(pathlib.Path(sys.argv[sys.argv.index("--lockfile") + 1]).read_text())
names = {"maven": "Maven", "npm": "npm", "pypi": "PyPI"}
packages = []
for each in bill["components"]:
    file = folder / names[each["purl"][4:].partition("/")[0]] / "all.zip"
    if "--download-offline-databases" in sys.argv and "NETWORK" in os.environ:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(os.environ["NETWORK"])
    if file.exists() and each["purl"] in json.loads(file.read_text()):
        name = each["name"] if "group" not in each else each["group"] + ":" + each["name"]
        packages.append({"package": {"name": name, "version": each["version"], "ecosystem": "any"},
                         "vulnerabilities": [{"id": "GHSA-1"}]})
print(json.dumps({"results": [{"packages": packages}] if packages else []}))
sys.exit(1 if packages else 127)
"""
EVERYBODY_KNOWS = [of.component()["purl"] for of in ECOSYSTEMS]


@pytest.fixture(scope="module")
def bill() -> dict[str, Any]:
    return bill_of_materials.bill()


@pytest.fixture(autouse=True)
def read_once(bill: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    """Reading all that ships takes longer than each of these tests."""
    monkeypatch.setattr(bill_of_materials, "bill", lambda *_: bill)


class Advisories:
    """The folder of the databases."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def add(self, of: Ecosystem, known: list[str]) -> Path:
        file = self._folder / "osv-scanner" / of.name / "all.zip"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(known))
        return file

    def add_all(self) -> None:
        for of in ECOSYSTEMS:
            self.add(of, EVERYBODY_KNOWS)


@pytest.fixture
def advisories(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Advisories:
    program = tmp_path / "osv-scanner"
    program.write_text(SCANNER)
    program.chmod(0o755)
    monkeypatch.setenv("OSV_SCANNER", str(program))
    monkeypatch.setenv("DRONEMAP_ADVISORIES", str(tmp_path / "advisories"))
    return Advisories(tmp_path / "advisories")


def shipped(of: Ecosystem) -> list[str]:
    """Names of the components that the scanner is given."""
    components = bill_of_materials.bill()["components"]
    return [each["purl"] for each in check_vulnerabilities.components_in(components, of)]


@pytest.fixture(params=ECOSYSTEMS, ids=[of.name for of in ECOSYSTEMS])
def ecosystem(request: pytest.FixtureRequest) -> Ecosystem:
    of: Ecosystem = request.param
    return of


def packed() -> str:
    (program,) = check_vulnerabilities.outside_ecosystems(bill_of_materials.bill()["components"])
    return f"{program['name']} {program['version']}"


def test_each_component_belongs_to_one_ecosystem() -> None:
    components = bill_of_materials.bill()["components"]
    kinds = [shipped(of) for of in ECOSYSTEMS]
    assert sum(len(each) for each in kinds) == len(components) - 1
    assert all(kinds)
    assert packed().startswith("postgresql ")


def test_planted_vulnerability_alone_is_no_finding(
    advisories: Advisories, capsys: pytest.CaptureFixture[str]
) -> None:
    advisories.add_all()
    assert check_vulnerabilities.main(["--offline"]) == NOTHING_KNOWN
    lines = capsys.readouterr().out.splitlines()
    assert lines == [
        *(f"Of {len(shipped(of))} {of.description} none has a known vulnerability." for of in ECOSYSTEMS),
        f"{packed()} was not checked: osv-scanner knows no programs. Compare it with {SECURITY_PAGE}",
        f"Not checked: {packed()}. Nothing is known of the rest.",
    ]


def test_known_vulnerability_of_shipped_component_is_named(
    advisories: Advisories, ecosystem: Ecosystem, capsys: pytest.CaptureFixture[str]
) -> None:
    advisories.add_all()
    advisories.add(ecosystem, [*EVERYBODY_KNOWS, shipped(ecosystem)[0]])
    assert check_vulnerabilities.main(["--offline"]) == KNOWN
    lines = capsys.readouterr().out.splitlines()
    assert [line for line in lines if line.endswith(": GHSA-1")]
    assert lines[-1] == f"Known vulnerabilities: in 1 of what ships. Not checked: {packed()}."


@pytest.mark.parametrize("database", [None, []], ids=["none", "empty"])
def test_incomplete_database_leaves_its_ecosystem_unchecked(
    advisories: Advisories,
    ecosystem: Ecosystem,
    database: list[str] | None,
    capsys: pytest.CaptureFixture[str],
) -> None:
    for of in ECOSYSTEMS:
        if of != ecosystem:
            advisories.add(of, EVERYBODY_KNOWS)
        elif database is not None:
            advisories.add(of, database)
    assert check_vulnerabilities.main(["--offline"]) == NOT_CHECKED
    lines = capsys.readouterr().out.splitlines()
    mine = f"{len(shipped(ecosystem))} {ecosystem.description}"
    assert [line for line in lines if line.startswith(f"{mine} were not checked: the scanner does not know")]
    assert not [line for line in lines if line.startswith(f"Of {mine}")]
    assert len([line for line in lines if " none has " in line]) == len(ECOSYSTEMS) - 1
    assert lines[-1] == f"Not checked: {mine}, {packed()}. Nothing is known of the rest."


def test_findings_are_reported_beside_unchecked_ecosystem(
    advisories: Advisories, capsys: pytest.CaptureFixture[str]
) -> None:
    advisories.add(ECOSYSTEMS[0], [*EVERYBODY_KNOWS, shipped(ECOSYSTEMS[0])[0]])
    assert check_vulnerabilities.main(["--offline"]) == KNOWN
    last = capsys.readouterr().out.splitlines()[-1]
    assert last.startswith("Known vulnerabilities: in 1 of what ships. Not checked: ")
    assert all(of.description in last for of in ECOSYSTEMS[1:])


def test_old_database_leaves_ecosystem_unchecked(
    advisories: Advisories, ecosystem: Ecosystem, capsys: pytest.CaptureFixture[str]
) -> None:
    advisories.add_all()
    long_ago = time.time() - 40 * 86_400
    os.utime(advisories.add(ecosystem, EVERYBODY_KNOWS), (long_ago, long_ago))
    assert check_vulnerabilities.main(["--offline"]) == NOT_CHECKED
    assert re.search(rf"the database {ecosystem.name} in \S+ is 40 days old", capsys.readouterr().out)


def test_databases_are_fetched_unless_offline(
    advisories: Advisories, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NETWORK", json.dumps(EVERYBODY_KNOWS))
    assert check_vulnerabilities.main(["--offline"]) == NOT_CHECKED
    assert check_vulnerabilities.main([]) == NOTHING_KNOWN
    assert check_vulnerabilities.main(["--offline"]) == NOTHING_KNOWN


@pytest.mark.parametrize("answer", ["", "{}", "[]"], ids=["silence", "no results", "something else"])
def test_broken_scanner_answer_is_not_checked(
    advisories: Advisories, tmp_path: Path, answer: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "osv-scanner").write_text(f"#!/bin/sh\necho '{answer}'\n")
    assert check_vulnerabilities.main(["--offline"]) == NOT_CHECKED
    output = capsys.readouterr().out
    assert output.count("the scanner ended with 0 and told nothing") == len(ECOSYSTEMS)
    assert "Nothing is known" not in output


def test_missing_scanner_is_not_checked(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("OSV_SCANNER", "/no/such/program")
    assert check_vulnerabilities.main([]) == NOT_CHECKED
    assert "osv-scanner (version 2) is not installed" in capsys.readouterr().out
