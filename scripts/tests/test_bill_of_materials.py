"""The bill of materials names all that ships, so that a scanner misses nothing."""

import json
import re
import zipfile
from pathlib import Path

import pytest

import bill_of_materials

MAVEN = re.compile(r"pkg:maven/[\w.-]+/[\w.-]+@[\w.-]+")
PIP = re.compile(r"pkg:pypi/[\w.-]+@[\w.-]+")
NPM = re.compile(r"pkg:npm/(%40[\w.-]+/)?[\w.-]+@[\w.-]+")


def test_bill_names_jar_libraries_and_page_packages() -> None:
    components = bill_of_materials.bill()["components"]

    with zipfile.ZipFile(bill_of_materials.JAR) as jar:
        names = [name for name in jar.namelist() if name.startswith("BOOT-INF/lib/")]
    inside = {Path(name).name for name in names if name.endswith(".jar")}
    named = {f"{each['name']}-{each['version']}.jar" for each in components if MAVEN.fullmatch(each["purl"])}
    assert {jar for jar in inside if not jar.startswith("dronemap-")} == named
    assert len(named) > 80
    wanted = json.loads(bill_of_materials.LOCK.read_text())["packages"][""]["dependencies"].items()
    page = {(each["name"], each["version"]) for each in components if NPM.fullmatch(each["purl"])}
    assert set(wanted) <= page
    hashed = [each for each in components if "hashes" in each]
    assert len(named) + len(page) == len(hashed)
    assert all(re.fullmatch(r"[0-9a-f]{64,128}", each["hashes"][0]["content"]) for each in hashed)


def test_bill_names_packed_libraries_and_python_packages() -> None:
    components = bill_of_materials.bill()["components"]
    packed = {
        each["version"] for each in components if each["name"].startswith("embedded-postgres-binaries-")
    }
    (postgres,) = [
        each for each in components if each["name"] == "postgresql" and each["type"] == "application"
    ]
    assert {f"{postgres['version']}.0"} == packed
    assert postgres["cpe"] == f"cpe:2.3:a:postgresql:postgresql:{postgres['version']}:*:*:*:*:*:*:*"
    of_python = {each["name"] for each in components if PIP.fullmatch(each["purl"])}
    assert of_python == {"pymavlink", "httpx", "websockets", "pydantic", "click", "rich"}


def test_bill_without_build_is_refused(tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match="build first"):
        bill_of_materials.bill(tmp_path / "dronemap.jar")


def test_bill_has_no_invented_coordinates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MAVEN_REPOSITORY", str(tmp_path))
    with pytest.raises(SystemExit, match="MAVEN_REPOSITORY"):
        bill_of_materials.bill()
