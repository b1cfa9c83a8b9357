"""A disk that is full, or becomes so, under a server."""

import contextlib
from pathlib import Path

from .conftest import Checkout, needs_root, small_disk

DISK = 5


def fill(folder: Path) -> None:
    with (folder / "filler").open("wb", buffering=0) as filler, contextlib.suppress(OSError):
        while True:
            filler.write(bytes(1 << 16))


@needs_root
def test_database_does_not_start_on_nearly_full_disk(built: Checkout, tmp_path: Path) -> None:
    with small_disk(tmp_path / "disk", "50m") as disk:
        outcome = built.run("up", "--no-demo", DRONEMAP_DATA_DIR=str(disk))
    assert outcome.returncode == DISK, outcome.stderr
    assert "the first start of the database needs" in outcome.stderr


@needs_root
def test_full_data_disk_is_reported_at_start(built: Checkout, tmp_path: Path) -> None:
    with small_disk(tmp_path / "disk", "4m") as disk:
        fill(disk)
        outcome = built.run("up", "--no-demo", DRONEMAP_DATA_DIR=str(disk / "data"))
    assert outcome.returncode == DISK, outcome.stderr
    assert "full" in outcome.stderr or "MB free" in outcome.stderr


@needs_root
def test_disk_full_at_run_time_is_reported(built: Checkout, tmp_path: Path) -> None:
    with small_disk(tmp_path / "disk", "600m") as disk:
        built.settings["DRONEMAP_DATA_DIR"] = str(disk)
        assert built.run("up", "--no-demo").returncode == 0
        fill(disk)
        assert "nearly full" in built.run("status").stderr
        assert built.run("down").returncode == 0
        outcome = built.run("up", "--no-demo")
        assert outcome.returncode == DISK, outcome.stderr
        assert "Make room and run the same command again" in outcome.stderr
        (disk / "filler").unlink()
        again = built.run("up", "--no-demo")
        assert again.returncode == 0, again.stderr
        built.run("down")
