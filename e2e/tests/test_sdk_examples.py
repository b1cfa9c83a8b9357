"""The examples of the Python client, run as they stand before four copters."""

import csv
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbclient import NotebookClient

from dronemap_e2e.api import Api
from dronemap_e2e.server import ROOT, Server
from dronemap_e2e.vehicles import Vehicles
from dronemap_e2e.waiting import wait_for

SDK = ROOT / "sdk-python"
EXAMPLES = SDK / "examples"


@dataclass
class Bench:
    """A folder for the files that examples write, and the environment that names the server."""

    folder: Path
    environment: dict[str, str]

    def run(self, name: str) -> str:
        done = subprocess.run(
            [sys.executable, EXAMPLES / f"{name}.py"],
            cwd=self.folder,
            env=self.environment,
            capture_output=True,
            text=True,
            timeout=300,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def rows(self, name: str) -> list[dict[str, str]]:
        with (self.folder / name).open(newline="") as file:
            return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def bench(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Bench]:
    folder = tmp_path_factory.mktemp("examples")
    server = Server(folder / "data")
    server.start()
    vehicles = Vehicles(server, folder / "sim.log")
    try:
        api = Api(server.address, server.local_key())
        awake = [vehicles.wake_next() for _ in range(4)]
        wait_for("the copters are ready to arm", lambda: all([api.ready(each) for each in awake]), 90)
        environment = os.environ | {
            "DRONEMAP_URL": server.address,
            "DRONEMAP_KEY": server.local_key(),
            "PYTHONPATH": str(SDK),
            "MPLBACKEND": "agg",
        }
        yield Bench(folder, environment)
    finally:
        vehicles.close()
        server.stop()


def test_hello_drone_tells_of_all_drones(bench: Bench) -> None:
    """End to end because an example has to run as it stands: program, server and vehicles."""
    said = bench.run("hello_drone")
    assert said.count("live") == 4
    told: dict[str, Any] = json.loads((bench.folder / "hello.json").read_text())
    assert told["autopilot"] in said
    assert told["position"]["latitude"] == pytest.approx(47.4, abs=0.1)


def test_simple_goto_flies_where_it_says(bench: Bench) -> None:
    """End to end because an example has to run as it stands: program, server and vehicles."""
    bench.run("simple_goto")
    rows = [row for row in bench.rows("goto.csv") if row["altitude_above_home"]]
    heights = [float(row["altitude_above_home"]) for row in rows]
    assert max(heights) == pytest.approx(20, abs=2)
    assert heights[-1] < 2
    home = float(rows[0]["latitude"])
    assert max(float(row["latitude"]) for row in rows) - home == pytest.approx(0.00045, abs=0.00003)


def test_notebook_draws_flight_of_the_example_before(bench: Bench) -> None:
    """End to end because the notebook has to run as it stands, with the libraries that it draws with."""
    notebook = nbformat.read(EXAMPLES / "flight_map.ipynb", as_version=4)  # type: ignore[no-untyped-call]
    before = dict(os.environ)
    os.environ.update(bench.environment)
    try:
        NotebookClient(notebook, timeout=120, resources={"metadata": {"path": bench.folder}}).execute()
    finally:
        os.environ.clear()
        os.environ.update(before)
    assert (bench.folder / "flight.png").read_bytes().startswith(b"\x89PNG")
    assert (bench.folder / "flight.html").read_text().count("polyline") > 10


def test_swarm_flies_four_squares_at_once(bench: Bench) -> None:
    """End to end because an example has to run as it stands: program, server and vehicles."""
    assert bench.run("swarm_of_four").count("is back") == 4
    features = json.loads((bench.folder / "swarm.geojson").read_text())["features"]
    assert sorted(feature["properties"]["height"] for feature in features) == [10, 15, 20, 25]
    for feature in features:
        north = [corner[1] for corner in feature["geometry"]["coordinates"] if corner[1] is not None]
        assert max(north) - min(north) == pytest.approx(0.00027, abs=0.00003)


def test_follower_keeps_its_place_beside_the_walker(bench: Bench) -> None:
    """End to end because an example has to run as it stands: program, server and vehicles."""
    assert "followed for 20 s" in bench.run("follow_me")
    tracked = [float(row["distance"]) for row in bench.rows("follow.csv") if row["state"] == "tracking"]
    assert tracked[-1] == pytest.approx(8, abs=4)


def test_log_analysis_has_a_line_for_each_flight(bench: Bench) -> None:
    """End to end because an example has to run as it stands: program, server and vehicles."""
    bench.run("log_analysis")
    flights = bench.rows("flights.csv")
    assert len(flights) >= 1
    assert all(float(flight["highest_m"]) > 5 for flight in flights)
    assert (bench.folder / "flights.md").read_text().count("\n| ") == len(flights) + 2
