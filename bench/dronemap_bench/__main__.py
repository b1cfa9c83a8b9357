"""`bench/run`: measures, and writes a table, a plot and JSON."""

import argparse
import datetime
import subprocess
import sys
from pathlib import Path

from . import configurations, machine, report, router
from .measure import measure
from .programs import ROOT


def main(arguments: list[str]) -> None:
    options = _options(arguments)
    chosen = configurations.named(options.configuration)
    if options.seconds:
        chosen = [c.short(options.seconds) for c in chosen]
    results = []
    for number, configuration in enumerate(chosen, 1):
        print(f"[{number}/{len(chosen)}] {configuration.name}: {configuration.what}", file=sys.stderr)
        result = measure(configuration)
        if options.router and configuration.impairment is None and configuration.flood is None:
            result["router"] = router.measure(configuration, options.router)
        results.append(result)
        whole = {"machine": about(), "configurations": results}
        report.write(options.out, options.name, whole)
    print(report.table(whole))


def _options(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="bench/run", description=__doc__)
    names = ", ".join(c.name for c in configurations.CONFIGURATIONS)
    parser.add_argument("configuration", nargs="*", help=f"which to measure: {names} (default: all)")
    parser.add_argument("--seconds", type=int, default=0, help="measure so long instead of a minute")
    parser.add_argument("--out", type=Path, default=ROOT / "bench" / "results", help="folder for the results")
    parser.add_argument("--name", default="latest", help="name of the result files")
    parser.add_argument("--router", type=Path, help="a mavlink-routerd that gets the same load beside it")
    return parser.parse_args(arguments)


def about() -> dict[str, str]:
    java = subprocess.run(["java", "-version"], capture_output=True, text=True, check=True).stderr
    revision = subprocess.run(
        ["git", "-C", str(ROOT), "describe", "--always", "--dirty"],
        capture_output=True,
        text=True,
        check=False,
    ).stdout
    return {
        "at": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "processor": machine.processor(),
        "java": java.splitlines()[0],
        "revision": revision.strip(),
    }


if __name__ == "__main__":
    main(sys.argv[1:])
