"""Checks what ships for known vulnerabilities, and reports what it could not check.

Usage: check_vulnerabilities.py [--offline] [--jar FILE]     after a build

Asks osv-scanner, with databases that it keeps in the folder DRONEMAP_ADVISORIES (.tools/advisories) and
fetches anew unless --offline is said. There is a database for each kind of thing that ships, and each is
judged by itself: something of its kind that is known to be vulnerable, and does not ship, is always asked
about, too; an answer without it proves nothing of the others of that kind.

Programs that lie packed in libraries have no database that osv-scanner asks: they are named as not checked,
with where to look, and have no part in the exit code, which would always be the same.

Exit code: 0 nothing is known, 1 something is, 3 a kind was not checked, and nothing is known of the rest.
A line for each kind says so, and the last line sums up.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bill_of_materials
from bill_of_materials import ROOT, Component

ACCEPTED = ROOT / "config" / "accepted-vulnerabilities.toml"
NOTHING_KNOWN, KNOWN, NOT_CHECKED = 0, 1, 3
MOST_DAYS = 30
SECONDS_A_DAY = 86_400
SECURITY_PAGE = "https://www.postgresql.org/support/security/"
PATIENCE_SECONDS = 600


@dataclass(frozen=True)
class Ecosystem:
    """One kind of things that ship, its database, and what everybody knows to be vulnerable in it."""

    name: str
    description: str
    kind: str
    planted: tuple[str, str]

    def component(self) -> Component:
        name, version = self.planted
        return {
            "type": "library",
            "name": name,
            "version": version,
            "purl": f"pkg:{self.kind}/{name.replace(':', '/')}@{version}",
        }


ECOSYSTEMS = (
    Ecosystem("Maven", "libraries of Java", "maven", ("org.apache.logging.log4j:log4j-core", "2.14.1")),
    Ecosystem("npm", "packages of the page", "npm", ("lodash", "4.17.11")),
    Ecosystem("PyPI", "packages of Python", "pypi", ("jinja2", "2.10")),
)


class NotChecked(Exception):
    """Reason for which an ecosystem was not checked."""


@dataclass(frozen=True)
class Finding:
    name: str
    version: str
    vulnerabilities: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.name} {self.version}: {', '.join(self.vulnerabilities)}"


def scanner() -> str:
    found = shutil.which(os.environ.get("OSV_SCANNER", "osv-scanner"))
    if found is None:
        raise NotChecked(
            "osv-scanner (version 2) is not installed; install it, or name it with OSV_SCANNER=FILE"
        )
    return found


def databases() -> Path:
    return Path(os.environ.get("DRONEMAP_ADVISORIES", ROOT / ".tools" / "advisories"))


def components_in(shipped: list[Component], of: Ecosystem) -> list[Component]:
    """Components of one ecosystem."""
    return [each for each in shipped if each["purl"].startswith(f"pkg:{of.kind}/")]


def outside_ecosystems(shipped: list[Component]) -> list[Component]:
    """Components of no ecosystem."""
    return [each for each in shipped if not any(each in components_in(shipped, of) for of in ECOSYSTEMS)]


def scan(program: str, components: list[Component], folder: Path, offline: bool) -> list[Finding]:
    """Findings of the scanner; that its program ends well is not taken for an answer."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        file = Path(temporary) / "dronemap.cdx.json"
        file.write_text(
            json.dumps(
                {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1, "components": components}
            )
        )
        fetching = [] if offline else ["--download-offline-databases"]
        ended = subprocess.run(
            [
                program,
                "scan",
                "source",
                "--lockfile",
                str(file),
                "--config",
                str(ACCEPTED),
                "--format",
                "json",
            ]
            + ["--offline-vulnerabilities", *fetching],
            env=os.environ | {"OSV_SCANNER_LOCAL_DB_CACHE_DIRECTORY": str(folder)},
            capture_output=True,
            text=True,
            timeout=PATIENCE_SECONDS,
            check=False,
        )
    sys.stderr.write(ended.stderr)
    try:
        results = json.loads(ended.stdout)["results"]
    except (ValueError, KeyError, TypeError):
        raise NotChecked(f"the scanner ended with {ended.returncode} and told nothing") from None
    return [
        finding_of(each) for result in results for each in result["packages"] if each.get("vulnerabilities")
    ]


def finding_of(package: dict[str, Any]) -> Finding:
    of = package["package"]
    return Finding(
        of["name"], of["version"], tuple(sorted(each["id"] for each in package["vulnerabilities"]))
    )


def verify_findings(findings: list[Finding], of: Ecosystem, folder: Path) -> list[Finding]:
    """Findings that ship, once the planted one was found by a database that is not too old."""
    if of.planted not in {(each.name, each.version) for each in findings}:
        raise NotChecked(
            f"the scanner does not know that {' '.join(of.planted)} is vulnerable, so its database {of.name}"
            f" in {folder} is missing or broken; run ./dronemap vulnerabilities where there is a network, or"
            " bring that folder"
        )
    files = [file.stat().st_mtime for file in folder.rglob("all.zip") if file.parent.name == of.name]
    if not files:
        raise NotChecked(f"the age of the database {of.name} in {folder} is not known")
    days = (time.time() - max(files)) / SECONDS_A_DAY
    if days > MOST_DAYS:
        raise NotChecked(
            f"the database {of.name} in {folder} is {days:.0f} days old; {MOST_DAYS} are the most"
        )
    return [each for each in findings if (each.name, each.version) != of.planted]


def check(jar: Path, offline: bool) -> int:
    shipped = bill_of_materials.bill(jar)["components"]
    known, unchecked = 0, []
    for of in ECOSYSTEMS:
        mine = components_in(shipped, of)
        try:
            found = verify_findings(
                scan(scanner(), [*mine, of.component()], databases(), offline), of, databases()
            )
        except (NotChecked, subprocess.TimeoutExpired) as why:
            print(f"{len(mine)} {of.description} were not checked: {why}.")
            unchecked.append(f"{len(mine)} {of.description}")
            continue
        for each in found:
            print(each)
        known += len(found)
        print(count_sentence(found, len(mine), of))
    by_hand = [f"{each['name']} {each['version']}" for each in outside_ecosystems(shipped)]
    for name in by_hand:
        print(f"{name} was not checked: osv-scanner knows no programs. Compare it with {SECURITY_PAGE}")
    return print_summary(known, unchecked, by_hand)


def count_sentence(found: list[Finding], of_how_many: int, of: Ecosystem) -> str:
    how_many = f"{len(found)} are known to be vulnerable" if found else "none has a known vulnerability"
    return f"Of {of_how_many} {of.description} {how_many}."


def print_summary(known: int, unchecked: list[str], by_hand: list[str]) -> int:
    missing = f"Not checked: {', '.join([*unchecked, *by_hand])}."
    if known:
        print(f"Known vulnerabilities: in {known} of what ships. {missing}")
        return KNOWN
    print(missing if len(unchecked) == len(ECOSYSTEMS) else f"{missing} Nothing is known of the rest.")
    return NOT_CHECKED if unchecked else NOTHING_KNOWN


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--offline", action="store_true", help="fetch no database")
    parser.add_argument("--jar", type=Path, default=bill_of_materials.JAR, help="what was built")
    chosen = parser.parse_args(arguments)
    return check(chosen.jar, chosen.offline)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
