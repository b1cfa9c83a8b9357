"""`bench/plan`: measures the planner, and writes a table, a plot and JSON."""

import argparse
import dataclasses
import json
import os
import sys
from pathlib import Path
from typing import Any

from ..__main__ import about
from ..programs import ROOT
from . import checker, flown, losses, modes, report, study
from .problems import Row, read
from .runs import Result, RunError, SolverRun, run

REPLAN, STUDY, FLOWN = "replan", "study", "flown"


def main(arguments: list[str]) -> None:
    options = _options(arguments)
    if options.mode == [REPLAN]:
        _replan(options)
        return
    if options.mode == [STUDY]:
        _study(options)
        return
    if options.mode == [FLOWN]:
        _flown(options)
        return
    rows = read(_data(options.data))
    if options.check:
        check(options.check, rows)
        return
    whole = [_measure(_changed(modes.named(name), options), rows, options) for name in options.mode]
    if not all(whole):
        sys.exit(1)


def _replan(options: argparse.Namespace) -> None:
    setup = losses.Setup(
        options.cases, options.waypoints, options.drones, options.budget_ms, options.solve_seconds
    )
    cases = losses.run(setup)
    losses.write(options.out, options.name or REPLAN, about(), setup, cases)
    print(losses.table(setup, cases))
    if any(case.faults for case in cases):
        sys.exit(1)


def _study(options: argparse.Namespace) -> None:
    done = study.run(1, options.cases)
    study.write(options.out, options.name or STUDY, about(), done)
    print(study.table(done))
    if done.broken:
        sys.exit(1)


def _flown(options: argparse.Namespace) -> None:
    flights = flown.run(options.cases)
    flown.write(options.out, options.name or FLOWN, about(), flights)
    print(flown.table(flights))
    if not flown.meets_forecast(flights):
        sys.exit(1)


def _measure(mode: modes.Mode, rows: list[Row], options: argparse.Namespace) -> bool:
    """False when a run failed: the others are written all the same."""
    chosen = [
        row for row in rows if mode.selects(row) and (not options.instance or row.name in options.instance)
    ]
    runs = [
        (row, SolverRun(solver, seed, seconds, mode.threads, mode.warm_up, mode.moved))
        for seconds in mode.seconds
        for row in chosen
        for seed in range(1, mode.seeds + 1)
        for solver in mode.solvers
    ]
    if not runs:
        raise SystemExit(f"No instance fits {mode.name}.")
    cpu = sum(plan.seconds + plan.warm_up for _, plan in runs)
    print(f"{mode.name}: {mode.what}; {len(runs)} runs, {cpu:.0f} CPU seconds", file=sys.stderr)
    results: list[Result] = []
    failed = 0
    where = about()
    name = options.name or mode.name
    for number, (row, plan) in enumerate(runs, 1):
        try:
            results.append(run(row, plan))
        except RunError as error:
            failed += 1
            print(f"FAILED: {error}", file=sys.stderr)
            continue
        summary = (
            f"{row.name} {plan.solver} {plan.seconds:g} s seed {plan.seed}: {results[-1].gap_percent:.2f} %"
        )
        print(f"[{number}/{len(runs)}] {summary}", file=sys.stderr)
        report.write(options.out, name, where, results)
    if results:
        print(report.table(where, results))
    return failed == 0


def _changed(mode: modes.Mode, options: argparse.Namespace) -> modes.Mode:
    wanted: dict[str, Any] = {
        "solvers": tuple(options.solver or ()),
        "seconds": tuple(options.seconds or ()),
        "seeds": options.seeds,
        "threads": options.threads,
        "moved": options.moved,
    }
    changes = {field: value for field, value in wanted.items() if value}
    if options.warm_up is not None:
        changes["warm_up"] = options.warm_up
    return dataclasses.replace(mode, **changes)


def check(file: Path, rows: list[Row]) -> None:
    """Checks written results once more; ends with 1 when any of them is wrong."""
    known = {(row.name, row.problem.aim): row for row in rows}
    wrong = 0
    results = json.loads(file.read_text())["results"]
    for result in results:
        row = known[result["instance"], result["aim"]]
        faults = checker.faults(row.problem, result["tours"])
        value = checker.value(row.problem, result["tours"])
        if abs(value - result["value"]) > 1e-6 * value:
            faults.append(f"says {result['value']}, is {value}")
        if faults:
            wrong += 1
            print(f"{row.name}: {'; '.join(faults[:5])}")
    print(f"{len(results)} results, {wrong} wrong")
    if wrong:
        sys.exit(1)


def _data(folder: Path | None) -> Path:
    around = os.environ.get("DRONEMAP_TEST_DATA")
    found = folder or (Path(around) / "mdmtsp" if around else None)
    if found is None or not (found / "index.csv").is_file():
        raise SystemExit(
            "The instances are wanted: --data FOLDER, or mdmtsp in the folder DRONEMAP_TEST_DATA."
        )
    return found


def _options(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="bench/plan",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="modes:\n"
        + "\n".join(f"  {mode.name:12} {mode.what}" for mode in modes.MODES)
        + f"\n  {REPLAN:12} random missions lose a drone (by itself, with the options from --cases on)"
        + f"\n  {STUDY:12} random missions flown in virtual time with random failures (by itself; --cases)"
        + f"\n  {FLOWN:12} random plans flown by simulated copters: time and energy (by itself; --cases)",
    )
    parser.add_argument("mode", nargs="*", default=["minmax-1s"], help="what to measure (default: minmax-1s)")
    parser.add_argument(
        "--data", type=Path, help="folder with index.csv (default: $DRONEMAP_TEST_DATA/mdmtsp)"
    )
    parser.add_argument("--instance", action="append", help="only this one; may be repeated")
    parser.add_argument("--solver", action="append", help="this one instead of the mode's; may be repeated")
    parser.add_argument("--seconds", action="append", type=float, help="so much CPU instead; may be repeated")
    parser.add_argument("--seeds", type=int, default=0, help="so many seeds instead")
    parser.add_argument(
        "--threads", type=int, default=0, help="so many threads instead; they share the CPU seconds"
    )
    parser.add_argument(
        "--warm-up", type=float, help="CPU seconds of warm-up instead; 0 counts from the start"
    )
    parser.add_argument("--moved", action="store_true", help="instances rotated, scaled and renumbered")
    parser.add_argument("--out", type=Path, default=ROOT / "bench" / "results", help="folder for the results")
    parser.add_argument("--name", help="name of the result files (default: the mode's)")
    parser.add_argument("--cases", type=int, default=200, help="so many missions (default: 200)")
    parser.add_argument("--waypoints", type=int, default=200, help="of each mission (default: 200)")
    parser.add_argument("--drones", type=int, default=10, help="of each mission (default: 10)")
    parser.add_argument("--budget-ms", type=float, default=100, help="for the better plan (default: 100)")
    parser.add_argument(
        "--solve-seconds", type=float, default=10, help="of the search to compare with (default: 10; 0: none)"
    )
    parser.add_argument(
        "--check", type=Path, metavar="FILE", help="judge the tours of written results, measure nothing"
    )
    return parser.parse_args(arguments)


if __name__ == "__main__":
    main(sys.argv[1:])
