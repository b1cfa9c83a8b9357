"""Makes the data that all test servers begin with, once for each build: most of their cost is the start."""

import fcntl
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path


def unpacked(jar: Path) -> Path:
    """The server with its libraries beside it, which starts in two thirds of the time."""
    assert jar.exists(), f"{jar} is missing: build first (./dronemap test does)"

    def unpack(folder: Path) -> None:
        options = ["-Djarmode=tools", "-jar", str(jar), "extract", "--destination", str(folder)]
        subprocess.run(["java", *options], check=True, stdout=subprocess.DEVNULL)

    return made_once(jar, "unpacked", unpack) / jar.name


def copy_initial_data(jar: Path, data: Path, first_start: Callable[[Path], None]) -> None:
    """Makes a folder as a first start leaves it, with secrets that other tests have too."""
    template = made_once(jar, "begun", first_start)
    data.parent.mkdir(parents=True, exist_ok=True)
    # Owners and rights are the database's own.
    subprocess.run(["cp", "-a", "--reflink=auto", str(template), str(data)], check=True)


def made_once(jar: Path, name: str, make: Callable[[Path], None], also_of: str = "") -> Path:
    """A folder beside the jar; made anew where the jar, or what it is made of besides, is another one."""
    folder = jar.parent / name
    # Builds that repeat themselves give a jar the same time of change.
    stamp, made = jar.parent / f"{name}.made-of", f"{jar.stat().st_ctime_ns}{also_of}"
    with (jar.parent / f"{name}.lock").open("w") as lock:
        # Several processes test at once.
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not stamp.exists() or stamp.read_text() != made:
            shutil.rmtree(folder, ignore_errors=True)
            make(folder)
            stamp.write_text(made)
    return folder
