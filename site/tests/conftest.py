"""The site as it is built from this checkout, and small checkouts with faults."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from dronemap_site.sources import ROOT, Sources

Checkout = Callable[[dict[str, str]], Sources]


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Built as `./dronemap docs` builds it."""
    folder = tmp_path_factory.mktemp("site")
    built = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--quiet", "--site-dir", folder],
        cwd=ROOT / "site",
        env=os.environ | {"NO_MKDOCS_2_WARNING": "1"},
        capture_output=True,
        text=True,
    )
    assert built.returncode == 0, built.stdout + built.stderr
    return folder


@pytest.fixture
def checkout(tmp_path: Path) -> Checkout:
    def make(files: dict[str, str]) -> Sources:
        for path, text in ({"README.md": "# Here\n"} | files).items():
            (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / path).write_text(text)
        return Sources.of(tmp_path)

    return make
