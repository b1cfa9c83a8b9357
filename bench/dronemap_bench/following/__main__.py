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
EXPERIMENT = "org.dronemap.cognitive.follow.FollowExperiment"
SITL_EXPERIMENT = "org.dronemap.cognitive.follow.SitlExperiment"
TRACKS = "org.dronemap.cognitive.follow.RandomFollowStudy"


def main(arguments: list[str]) -> None:
    if arguments[:1] == ["tracks"]:
        sys.exit(_run(TRACKS, _tracks(arguments[1:]), None).returncode)
    options = _options(arguments)
    with tempfile.TemporaryDirectory() as folder:
        tracks = [gpx.written(file, Path(folder)) for file in options.gpx]
        lines = _fly(EXPERIMENT, [str(options.seeds), *tracks])
        if options.sitl:
            lines += _fly(SITL_EXPERIMENT, [str(options.sitl), str(options.seeds)])
        rows = [report.parse(line) for line in lines]
    report.write(options.out, options.name, about(), options.seeds, rows)
    print(report.table(about(), options.seeds, rows))


def _fly(main_class: str, arguments: list[str]) -> list[str]:
    flown = _run(main_class, arguments, subprocess.PIPE)
    flown.check_returncode()
    return flown.stdout.splitlines()


def _run(main_class: str, arguments: list[str], output: int | None) -> subprocess.CompletedProcess[str]:
    folders = [f"dronemap-{module}/target/classes" for module in MODULES]
    path = ":".join(str(ROOT / folder) for folder in [*folders, "dronemap-cognitive/target/test-classes"])
    return subprocess.run(
        ["java", "-cp", path, main_class, *arguments], stdout=output, text=True, check=False
    )


def _tracks(arguments: list[str]) -> list[str]:
    parser = argparse.ArgumentParser(
        prog="bench/follow tracks",
        description="Random follows near fences, and many drones at once; ends with 1 if any goes beyond.",
    )
    parser.add_argument("--first", type=int, default=0, help="seed of the first one (0)")
    parser.add_argument("--count", type=int, default=10_000, help="so many follows near fences (10000)")
    parser.add_argument(
        "--swarms", type=int, default=400, help="so often three on one target, and ten at once (400)"
    )
    parser.add_argument(
        "--separation", type=float, default=10, help="metres that drones are to stay apart (10)"
    )
    parser.add_argument("--height", type=float, default=5, help="or metres in height (5)")
    options = parser.parse_args(arguments)
    return [str(each) for each in vars(options).values()]


def _options(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="bench/follow", description=__doc__)
    parser.add_argument("--seeds", type=int, default=10, help="so many walks of each kind (10)")
    parser.add_argument("--gpx", type=Path, nargs="*", default=[], help="recorded tracks to walk as well")
    parser.add_argument(
        "--sitl",
        type=Path,
        help="an ArduCopter binary, copter.parm beside it: it follows too, in real time",
    )
    parser.add_argument("--out", type=Path, default=ROOT / "bench" / "results", help="folder for the results")
    parser.add_argument("--name", default="following", help="name of the result files")
    return parser.parse_args(arguments)


if __name__ == "__main__":
    main(sys.argv[1:])
