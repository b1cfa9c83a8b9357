"""Lists all that ships as a CycloneDX bill of materials, for scanners of known vulnerabilities.

Usage: bill_of_materials.py [OUT.json]     after a build; without a name to the standard output

Asks nobody: reads the jar, the local Maven repository that it was put together from (which alone knows
the coordinates of a library that does not say them itself), the page's lock file, and what the signing relay
and the Python client ask for, in the versions that they are tested with.
"""

import base64
import hashlib
import json
import os
import re
import sys
import tomllib
import zipfile
from pathlib import Path
from typing import Any
from urllib.parse import quote

ROOT = Path(__file__).resolve().parents[1]
JAR = ROOT / "dronemap-ws" / "target" / "dronemap.jar"
LOCK = ROOT / "web-client" / "package-lock.json"
PYTHON = (ROOT / "signing-relay" / "pyproject.toml", ROOT / "sdk-python" / "pyproject.toml")
TESTED = ROOT / "scripts" / "requirements-test.txt"
LIBRARIES = "BOOT-INF/lib/"
OWN = "dronemap-"
# Put in by what packs the jar, which carries it inside itself: it is never fetched by its own name.
PACKED = {"spring-boot-jarmode-tools": "org.springframework.boot"}
# PostgreSQL itself lies in these: a program with weaknesses of its own, which no list of libraries has.
PACKED_POSTGRES = "embedded-postgres-binaries-"

Component = dict[str, Any]


def repository() -> Path:
    return Path(os.environ.get("MAVEN_REPOSITORY", Path.home() / ".m2" / "repository"))


def libraries(jar: Path, fetched: Path) -> list[Component]:
    """Libraries in the jar that are not the product's own."""
    with zipfile.ZipFile(jar) as whole:
        files = {
            name.removeprefix(LIBRARIES): whole.read(name)
            for name in whole.namelist()
            if name.startswith(LIBRARIES) and name.endswith(".jar")
        }
    places = {place.name: place for place in fetched.rglob("*.jar") if place.name in files}
    return [library(name, files[name], places, fetched) for name in sorted(files) if not name.startswith(OWN)]


def library(name: str, content: bytes, places: dict[str, Path], fetched: Path) -> Component:
    artifact, _, version = name.removesuffix(".jar").rpartition("-")
    if artifact in PACKED:
        return maven(PACKED[artifact], artifact, version, content)
    if name not in places:
        raise SystemExit(
            f"{name} is not in {fetched}; set MAVEN_REPOSITORY to where the build fetched it to."
        )
    version, artifact, *group = reversed(places[name].parent.relative_to(fetched).parts)
    return maven(".".join(reversed(group)), artifact, version, content)


def maven(group: str, artifact: str, version: str, content: bytes) -> Component:
    return {
        "type": "library",
        "group": group,
        "name": artifact,
        "version": version,
        "purl": f"pkg:maven/{quote(group)}/{quote(artifact)}@{quote(version)}",
        "hashes": [{"alg": "SHA-256", "content": hashlib.sha256(content).hexdigest()}],
    }


def programs(found: list[Component]) -> list[Component]:
    """Programs that are packed in libraries."""
    versions = {each["version"] for each in found if each["name"].startswith(PACKED_POSTGRES)}
    return [postgres(version) for version in sorted(versions)]


def postgres(packed: str) -> Component:
    version = packed.removesuffix(".0")
    return {
        "type": "application",
        "name": "postgresql",
        "version": version,
        "purl": f"pkg:generic/postgresql@{quote(version)}",
        "cpe": f"cpe:2.3:a:postgresql:postgresql:{version}:*:*:*:*:*:*:*",
    }


def of_python(projects: tuple[Path, ...], tested: Path) -> list[Component]:
    """Packages that pip fetches beside these projects."""
    versions = dict(line.split("==") for line in tested.read_text().split())
    wanted = [
        re.split(r"[<>=]", dependency)[0]
        for project in projects
        for dependency in tomllib.loads(project.read_text())["project"]["dependencies"]
    ]
    return [
        {
            "type": "library",
            "name": name,
            "version": versions[name],
            "purl": f"pkg:pypi/{name}@{versions[name]}",
        }
        for name in wanted
    ]


def packages(lock: Path) -> list[Component]:
    """Packages that go into the page; what builds and tests it stays out."""
    listed = json.loads(lock.read_text())["packages"]
    return [
        package(place.rpartition("node_modules/")[2], entry)
        for place, entry in sorted(listed.items())
        if place and not entry.get("dev")
    ]


def package(name: str, entry: dict[str, Any]) -> Component:
    algorithm, _, digest = str(entry["integrity"]).partition("-")
    return {
        "type": "library",
        "name": name,
        "version": entry["version"],
        "purl": f"pkg:npm/{quote(name, safe='/')}@{quote(entry['version'])}",
        "hashes": [{"alg": f"SHA-{algorithm[3:]}", "content": base64.b64decode(digest).hex()}],
    }


def bill(jar: Path = JAR, lock: Path = LOCK) -> dict[str, Any]:
    if not jar.exists():
        raise SystemExit(f"{jar} is missing: build first (./dronemap build).")
    of_java = libraries(jar, repository())
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {"component": {"type": "application", "name": "dronemap"}},
        "components": of_java + programs(of_java) + packages(lock) + of_python(PYTHON, TESTED),
    }


def main(arguments: list[str]) -> None:
    text = json.dumps(bill(), indent=2) + "\n"
    if arguments:
        Path(arguments[0]).write_text(text)
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main(sys.argv[1:])
