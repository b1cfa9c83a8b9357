"""`bench/faces`: what calls and viewers cost, of this version and another one in turn; a table and JSON."""

import argparse
import json
import os
import sys
from pathlib import Path

from ..__main__ import about
from ..programs import ROOT, SERVER_JAR, Json
from . import report, trial


def main(arguments: list[str]) -> int:
    usual = trial.Options()
    parser = argparse.ArgumentParser(prog="bench/faces", description=__doc__)
    parser.add_argument("--before", type=Path, help="the dronemap.jar of a version to compare with")
    parser.add_argument("--rounds", type=int, default=usual.rounds)
    parser.add_argument("--out", type=Path, default=ROOT / "bench" / "results" / "faces.json")
    chosen = parser.parse_args(arguments)
    options = trial.Options(rounds=chosen.rounds)
    versions = {report.NOW: SERVER_JAR} | ({report.BEFORE: chosen.before} if chosen.before else {})
    load = os.getloadavg()[0]
    rounds: dict[str, list[Json]] = {version: [] for version in versions}
    for number in range(options.rounds):
        for version, jar in versions.items():
            print(f"[{number + 1}/{options.rounds}] {version}", file=sys.stderr)
            rounds[version].append(trial.measure(options, jar))
    figures = report.summary(rounds)
    machine = about()
    chosen.out.parent.mkdir(parents=True, exist_ok=True)
    whole = {"machine": machine, "loadBefore": load, "summary": figures, "rounds": rounds}
    chosen.out.write_text(json.dumps(whole, indent=1) + "\n")
    print(report.table(figures, machine, load))
    wrong = report.missed(figures)
    for sentence in wrong:
        print(f"Missed: {sentence}.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
