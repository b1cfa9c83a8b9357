"""`bench/follow`: flies the trials, and writes a table, JSON and a report with plots."""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

from ..__main__ import about
from ..programs import ROOT
from . import gpx, report

MODULES = ("cognitive", "core", "mavlink", "sim")
MAIN = "org.dronemap.cognitive.follow.Experiment"


def main(words: list[str]) -> None:
    options = _options(words)
    with tempfile.TemporaryDirectory() as folder:
        tracks = [gpx.written(file, Path(folder)) for file in options.gpx]
        rows = [report.parse(line) for line in _fly([str(options.seeds), *tracks])]
    report.write(options.out, options.name, about(), options.seeds, rows)
    print(report.table(about(), options.seeds, rows))


def _fly(words: list[str]) -> list[str]:
    folders = [f"dronemap-{module}/target/classes" for module in MODULES]
    path = ":".join(str(ROOT / folder) for folder in [*folders, "dronemap-cognitive/target/test-classes"])
    return subprocess.run(
        ["java", "-cp", path, MAIN, *words], stdout=subprocess.PIPE, text=True, check=True
    ).stdout.splitlines()


def _options(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="bench/follow", description=__doc__)
    parser.add_argument("--seeds", type=int, default=10, help="so many walks of each kind (10)")
    parser.add_argument("--gpx", type=Path, nargs="*", default=[], help="recorded tracks to walk as well")
    parser.add_argument("--out", type=Path, default=ROOT / "bench" / "results", help="folder for the results")
    parser.add_argument("--name", default="following", help="name of the result files")
    return parser.parse_args(words)


if __name__ == "__main__":
    main(sys.argv[1:])
