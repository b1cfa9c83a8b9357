"""Looks whether anything that ships has a known vulnerability, and says so when it cannot tell.

Usage: check_vulnerabilities.py [--offline] [--jar FILE]     after a build

Asks osv-scanner, with databases that it keeps in the folder DRONEMAP_ADVISORIES (.tools/advisories) and
fetches anew unless --offline is said. Two libraries that are known to be vulnerable, and do not ship, are
always asked about, too: an answer without them proves nothing of the others.

Exit code: 0 nothing is known, 1 something is, 3 not checked. The last line says which, and why.
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
PATIENCE_SECONDS = 600
PLANTED = {
    ("org.apache.logging.log4j:log4j-core", "2.14.1"): "pkg:maven/org.apache.logging.log4j/log4j-core@2.14.1",
    ("lodash", "4.17.11"): "pkg:npm/lodash@4.17.11",
}


class NotChecked(Exception):
    """Why nothing can be said."""


@dataclass(frozen=True)
class Finding:
    name: str
    version: str
    vulnerabilities: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.name} {self.version}: {', '.join(self.vulnerabilities)}"


def planted() -> list[Component]:
    return [
        {"type": "library", "name": name, "version": version, "purl": purl}
        for (name, version), purl in PLANTED.items()
    ]


def scanner() -> str:
    found = shutil.which(os.environ.get("OSV_SCANNER", "osv-scanner"))
    if found is None:
        raise NotChecked(
            "osv-scanner (version 2) is not installed; install it, or name it with OSV_SCANNER=FILE"
        )
    return found


def database() -> Path:
    return Path(os.environ.get("DRONEMAP_ADVISORIES", ROOT / ".tools" / "advisories"))


def ask(program: str, bill: dict[str, Any], folder: Path, offline: bool) -> list[Finding]:
    """What the scanner answers; that its program ends well is not taken for an answer."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        file = Path(temporary) / "dronemap.cdx.json"
        file.write_text(json.dumps(bill))
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
    return [finding(each) for result in results for each in result["packages"] if each.get("vulnerabilities")]


def finding(package: dict[str, Any]) -> Finding:
    of = package["package"]
    return Finding(
        of["name"], of["version"], tuple(sorted(each["id"] for each in package["vulnerabilities"]))
    )


def proved(findings: list[Finding], folder: Path) -> list[Finding]:
    """Those that ship, once the planted ones were found by a database that is not too old."""
    unseen = PLANTED.keys() - {(each.name, each.version) for each in findings}
    if unseen:
        names = ", ".join(" ".join(each) for each in sorted(unseen))
        raise NotChecked(
            f"the scanner does not know that {names} is vulnerable, so its database in {folder} is missing"
            " or broken; run ./dronemap vulnerabilities where there is a network, or bring that folder"
        )
    newest = max(file.stat().st_mtime for file in folder.rglob("all.zip"))
    days = (time.time() - newest) / SECONDS_A_DAY
    if days > MOST_DAYS:
        raise NotChecked(f"the database in {folder} is {days:.0f} days old; {MOST_DAYS} are the most")
    return [each for each in findings if (each.name, each.version) not in PLANTED]


def check(jar: Path, offline: bool) -> int:
    bill = bill_of_materials.bill(jar)
    count = len(bill["components"])
    bill["components"] = bill["components"] + planted()
    folder = database()
    try:
        found = proved(ask(scanner(), bill, folder, offline), folder)
    except (NotChecked, subprocess.TimeoutExpired) as why:
        print(f"Known vulnerabilities were not checked: {why}.")
        return NOT_CHECKED
    for each in found:
        print(each)
    if found:
        print(f"{len(found)} of {count} libraries and packages have known vulnerabilities.")
        return KNOWN
    print(f"Of {count} libraries and packages none has a known vulnerability.")
    return NOTHING_KNOWN


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--offline", action="store_true", help="fetch no database")
    parser.add_argument("--jar", type=Path, default=bill_of_materials.JAR, help="what was built")
    chosen = parser.parse_args(arguments)
    return check(chosen.jar, chosen.offline)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
