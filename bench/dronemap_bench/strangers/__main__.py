"""`bench/strangers`: strangers at the WebSocket ports, while others go on; a table and JSON."""

import argparse
import json
import sys
from pathlib import Path

from ..__main__ import about
from ..programs import ROOT
from . import report, trial
from .others import VEHICLES


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="bench/strangers", description=__doc__)
    usual = trial.Options()
    parser.add_argument("--rounds", type=int, default=usual.rounds)
    parser.add_argument("--warm-up-seconds", type=float, default=usual.warm_up_seconds)
    parser.add_argument("--megabytes", type=int, default=usual.megabytes, help="in each round at each port")
    parser.add_argument("--calm-seconds", type=float, default=usual.calm_seconds)
    parser.add_argument("--least-seconds", type=float, default=usual.least_seconds, help="of one attack")
    parser.add_argument("--most-seconds", type=float, default=usual.most_seconds, help="of one attack")
    parser.add_argument("--strangers", type=int, default=usual.strangers)
    parser.add_argument("--niceness", type=int, default=usual.niceness, help="of the strangers' process")
    parser.add_argument(
        "--many-addresses", action="store_true", help="each connection of a stranger from another one"
    )
    parser.add_argument("--out", type=Path, default=ROOT / "bench" / "results" / "strangers.json")
    options = vars(parser.parse_args(arguments))
    out: Path = options.pop("out")
    result = trial.run(trial.Options(**options))
    figures = report.summary(result)
    machine = about()
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text(json.dumps({"machine": machine, "summary": figures, **result}, indent=1) + "\n")
    print(report.table(figures, machine))
    missed = report.missed(figures, result, VEHICLES)
    for sentence in missed:
        print(f"Missed: {sentence}.")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
