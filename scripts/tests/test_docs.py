"""The documentation site: built into a folder, served until somebody ends it, never over other files."""

import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from .conftest import Checkout, free_port
from .running import get
from .waiting import until

PROGRAMS = Path(sys.prefix)
USAGE, PORT, BUILD, INTERRUPTED = 2, 4, 7, 130


@pytest.fixture
def documented(checkout: Checkout) -> Iterator[Checkout]:
    """A checkout to which the programs that build the site have been given: those that the tests have."""
    tools = checkout.path / ".tools"
    (tools / "docs").mkdir(parents=True)
    (tools / "docs" / "venv").symlink_to(PROGRAMS)
    (tools / "app").mkdir()
    (tools / "app" / "docs.stamp").write_text(checkout.inside("hash_of site/requirements.txt") + "\n")
    checkout.settings["DRONEMAP_DOCS_PORT"] = str(free_port())
    yield checkout


def test_site_is_built_into_a_folder_and_served_until_it_is_interrupted(
    documented: Checkout, tmp_path: Path
) -> None:
    site = tmp_path / "site"
    outcome = documented.run("docs", "--build", str(site))
    assert outcome.returncode == 0, outcome.stderr
    assert f"Built the documentation in {site}" in outcome.stdout
    assert "<title>" in (site / "index.html").read_text()
    assert (site / "reference" / "rest" / "drones.html").exists()
    assert documented.run("docs", "--build", str(site)).returncode == 0, (
        "a site may be built over an older one"
    )

    with subprocess.Popen(
        [documented.path / "dronemap", "docs"],
        env=documented.environment(),
        stdout=subprocess.PIPE,
        text=True,
        start_new_session=True,
    ) as served:
        assert served.stdout
        told = (re.search(r"http://127\.0\.0\.1:\d+", line) for line in served.stdout)
        address = next(found[0] for found in told if found)
        assert address.endswith(f":{documented.settings['DRONEMAP_DOCS_PORT']}")
        until("the site is served", lambda: answers(address), 30)
        other = documented.run("docs")
        assert other.returncode == PORT
        assert "DRONEMAP_DOCS_PORT=" in other.stderr
        assert "./dronemap docs" in other.stderr
        served.send_signal(signal.SIGINT)
        assert served.wait(30) == INTERRUPTED
    assert not answers(address)


def answers(address: str) -> bool:
    try:
        return "<title>Dronemap" in get(address + "/index.html")[1]
    except OSError:
        return False


def test_folder_with_other_files_is_left_alone(documented: Checkout, tmp_path: Path) -> None:
    (tmp_path / "letter.txt").write_text("Dear")
    outcome = documented.run("docs", "--build", str(tmp_path))
    assert outcome.returncode == USAGE
    assert f"{tmp_path} has files that are no documentation site" in outcome.stderr
    assert (tmp_path / "letter.txt").read_text() == "Dear"


def test_dead_link_fails_the_build_with_its_line(documented: Checkout, tmp_path: Path) -> None:
    with (documented.path / "docs" / "times.md").open("a") as page:
        page.write("\n[nowhere](nowhere.md)\n")
    line = len((documented.path / "docs" / "times.md").read_text().splitlines())
    outcome = documented.run("docs", "--build", str(tmp_path / "site"))
    assert outcome.returncode == BUILD
    log = (documented.path / ".tools" / "logs" / "docs.log").read_text()
    assert f"docs/times.md:{line}: The link leads to docs/nowhere.md, which is not there." in log


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("--bild", "x"), "docs does not know '--bild'"),
        (("--build",), "--build needs one folder"),
        (("",), "docs does not know ''"),
    ],
)
def test_wrong_use_is_told(untouched: Checkout, arguments: tuple[str, ...], sentence: str) -> None:
    outcome = untouched.run("docs", *arguments)
    assert outcome.returncode == USAGE
    assert sentence in outcome.stderr
