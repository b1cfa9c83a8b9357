"""`bench/watch`: the processor time of one program in Python that watches a fleet; a table and JSON."""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from .__main__ import about
from .programs import LOAD_JAR, ROOT, Json, Server

GOAL_PERCENT = 25.0
#: Reads each state of each drone, by the client.
CLIENT = """
import json, sys, time
from dronemap import Dronemap
count, seconds = int(sys.argv[1]), float(sys.argv[2])
with Dronemap.connect() as server:
    seen, read, begun, used = set(), 0, None, 0.0
    for change in server.changes():
        position = change.state.position
        seen.add(change.id)
        if begun is None and len(seen) == count:
            begun, used, read = time.monotonic(), time.process_time(), 0
        read += 1
        if begun is not None and time.monotonic() - begun >= seconds:
            break
    took = time.monotonic() - begun
    print(json.dumps({"percent": 100 * (time.process_time() - used) / took, "states": read / took}))
"""
#: Reads the same messages and makes no objects of them but those of JSON.
BARE = """
import json, os, sys, time
from urllib.request import Request, urlopen
from websockets.sync.client import connect
count, seconds = int(sys.argv[1]), float(sys.argv[2])
key = {"Authorization": "Bearer " + os.environ["DRONEMAP_KEY"]}
settings = json.load(urlopen(Request(os.environ["DRONEMAP_URL"] + "/api/v1/settings", headers=key)))
address = f"ws://127.0.0.1:{settings['streamPort']}/stream"
with connect(address, additional_headers=key, max_size=None) as stream:
    seen, read, begun, used = set(), 0, None, 0.0
    while begun is None or time.monotonic() - begun < seconds:
        message = json.loads(stream.recv())
        if message["type"] != "drone":
            continue
        seen.add(message["drone"]["id"])
        if begun is None and len(seen) == count:
            begun, used, read = time.monotonic(), time.process_time(), 0
        read += 1
    took = time.monotonic() - begun
    print(json.dumps({"percent": 100 * (time.process_time() - used) / took, "states": read / took}))
"""
PROGRAMS = {"the client": CLIENT, "a bare client": BARE}


@dataclass(frozen=True)
class Options:
    """How many drones are watched, for how long, how often."""

    rounds: int = 5
    drones: int = 200
    seconds: float = 20.0


def measure(options: Options) -> dict[str, list[Json]]:
    """Percent of a core and states a second, of each program in turn."""
    with tempfile.TemporaryDirectory() as folder:
        server = Server(Path(folder) / "data")
        fleet = _fleet(server, options.drones)
        try:
            named = {"DRONEMAP_URL": f"http://127.0.0.1:{server.http_port}", "DRONEMAP_KEY": server.key()}
            rounds: dict[str, list[Json]] = {program: [] for program in PROGRAMS}
            for number in range(options.rounds):
                for program, text in PROGRAMS.items():
                    print(f"[{number + 1}/{options.rounds}] {program}", file=sys.stderr)
                    rounds[program].append(_run(text, options, named))
            return rounds
        finally:
            fleet.terminate()
            fleet.wait()
            server.stop()


def _fleet(server: Server, count: int) -> "subprocess.Popen[bytes]":
    address = f"udp://127.0.0.1:{server.udp_port}"
    return subprocess.Popen(
        ["java", "-jar", str(LOAD_JAR), "--connect", address, "--count", str(count), "--sysid", "1"],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


def _run(program: str, options: Options, named: Mapping[str, str]) -> Json:
    done = subprocess.run(
        [sys.executable, "-c", program, str(options.drones), str(options.seconds)],
        env=os.environ | named | {"PYTHONPATH": str(ROOT / "sdk-python")},
        capture_output=True,
        text=True,
        timeout=120 + options.seconds,
    )
    if done.returncode != 0:
        raise SystemExit(done.stderr)
    figures: Json = json.loads(done.stdout)
    return figures


def summary(rounds: Mapping[str, list[Json]]) -> Json:
    return {
        program: {
            figure: {
                "median": statistics.median(each[figure] for each in made),
                "worst": max(each[figure] for each in made),
            }
            for figure in ("percent", "states")
        }
        for program, made in rounds.items()
    }


def table(figures: Json, options: Options, load: float) -> str:
    machine = about()
    lines = [
        f"{options.drones} drones, {machine['processor']}, load {load:.1f} before it began.",
        "",
        "| program | % of a core, median | worst | states a second |",
        "| --- | --- | --- | --- |",
    ]
    for program, each in figures.items():
        percent, states = each["percent"], each["states"]
        row = f"{percent['median']:.1f} | {percent['worst']:.1f} | {states['median']:.0f}"
        lines.append(f"| {program} | {row} |")
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    usual = Options()
    parser = argparse.ArgumentParser(prog="bench/watch", description=__doc__)
    parser.add_argument("--rounds", type=int, default=usual.rounds)
    parser.add_argument("--drones", type=int, default=usual.drones)
    parser.add_argument("--seconds", type=float, default=usual.seconds)
    parser.add_argument("--out", type=Path, default=ROOT / "bench" / "results" / "watch.json")
    chosen = parser.parse_args(arguments)
    options = Options(chosen.rounds, chosen.drones, chosen.seconds)
    load = os.getloadavg()[0]
    rounds = measure(options)
    figures = summary(rounds)
    chosen.out.parent.mkdir(parents=True, exist_ok=True)
    whole = {"machine": about(), "loadBefore": load, "summary": figures, "rounds": rounds}
    chosen.out.write_text(json.dumps(whole, indent=1) + "\n")
    print(table(figures, options, load))
    if figures["the client"]["percent"]["median"] > GOAL_PERCENT:
        print(f"Missed: {GOAL_PERCENT:.0f} % of a core.")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
