"""Parameters: read, searched, changed with proof, saved and loaded; over good links and bad ones."""

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.impairer import BAD, CLEAR, CUT, Impairer, Weather
from dronemap_e2e.plugged import PluggedStation
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS

COUNT = 1000


@dataclass(frozen=True)
class Bench:
    """One simulated vehicle behind a link that a test may spoil, with a station plugged into it."""

    api: Api
    simulator: Simulator
    link: Impairer
    station: PluggedStation
    system_id: int
    drone: str

    @property
    def path(self) -> str:
        return f"/drones/{self.drone}/parameters"

    def read(self) -> None:
        record = self.api.call("POST", self.path + "/refresh?wait=60", None).json()
        assert record["outcome"] == {"result": "succeeded", "by": None, "reason": None}, record
        assert record["progress"]["done"] == record["progress"]["total"] == COUNT

    def put(self, name: str, value: float) -> Json:
        answer = self.api.call("PUT", f"{self.path}/{name}?wait=60", {"value": value})
        assert answer.ok, answer.text
        record: Json = answer.json()
        return record

    def shown(self, name: str) -> float:
        found = self.api.get(f"{self.path}?search={name}")["parameters"]
        value: float = next(p["value"] for p in found if p["name"] == name)
        return value


@pytest.fixture(params=["arducopter", "px4"])
def bench(request: pytest.FixtureRequest, server: Server, api: Api, tmp_path: Path) -> Iterator[Bench]:
    system_id = next(SYSTEM_IDS)
    link = Impairer(server.udp_port, seed=system_id)
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{link.port}",
        *("--sysid", str(system_id), "--personality", request.param, "--parameters", str(COUNT)),
    )
    station = PluggedStation(link, system_id)

    def listed() -> str | None:
        return next((d["id"] for d in api.drones() if d["link"]["systemId"] == system_id), None)

    drone = wait_for("the vehicle is listed", listed, 60)
    yield Bench(api, simulator, link, station, system_id, drone)
    simulator.stop()
    link.close()


def test_reads_searches_changes_and_proves_it(bench: Bench) -> None:
    assert bench.api.get(bench.path)["readAt"] is None
    bench.read()

    assert bench.api.get(bench.path)["total"] == COUNT
    found = bench.api.get(bench.path + "?search=0042+spare")["parameters"]
    assert [p["name"] for p in found] == ["SPARE_0042"]
    assert bench.put("SPARE_0042", 0.1)["outcome"]["result"] == "succeeded"
    assert bench.put("SPARE_0001", 7)["outcome"]["result"] == "succeeded"
    held = bench.station.parameters()
    assert held["SPARE_0042"][0] == pytest.approx(0.1)
    assert whole(bench, held["SPARE_0001"][0]) == 7
    assert bench.shown("SPARE_0001") == 7


def whole(bench: Bench, told: float) -> float:
    """PX4 sends whole numbers as their bits."""
    if bench.api.drone(bench.drone)["autopilot"] != "PX4":
        return told
    return float(struct.unpack("<i", struct.pack("<f", told))[0])


def test_says_what_the_vehicle_holds_when_it_silently_kept_something_else(bench: Bench) -> None:
    bench.read()
    bench.simulator.fault(f"{bench.system_id} alter SPARE_0003")

    record = bench.put("SPARE_0003", 20)

    assert record["outcome"] == {
        "result": "failed",
        "by": None,
        "reason": "The vehicle holds SPARE_0003 = 21, not 20.",
    }
    assert bench.shown("SPARE_0003") == 21


def test_refuses_what_the_vehicle_does_not_have_before_anything_is_sent(bench: Bench) -> None:
    bench.read()

    unknown = bench.api.call("PUT", bench.path + "/NOBODY", {"value": 1})
    broken = bench.api.call("PUT", bench.path + "/SPARE_0001", {"value": 1.5})

    assert (unknown.status_code, unknown.json()["field"]) == (422, "name")
    assert (broken.status_code, broken.json()["field"]) == (422, "value")
    assert "whole number" in broken.json()["allowed"]


@pytest.mark.parametrize("form", ["list", "table"])
def test_a_file_goes_round_with_a_break_in_the_middle(bench: Bench, form: str) -> None:
    bench.read()
    saved = bench.api.text(f"{bench.path}/file?form={form}")
    before = bench.station.parameters()
    changed = [f"SPARE_{number:04d}" for number in range(100, 200)]
    body = {"type": "setParameters", "parameters": [{"name": name, "value": 50} for name in changed]}
    assert bench.api.do(bench.drone, **body)
    assert bench.station.parameters() != before
    compared = bench.api.post_text(bench.path + "/file?dryRun=true", saved).json()
    assert 90 <= len(compared["different"]) <= 100
    assert compared["same"] == COUNT - len(compared["different"])
    assert (compared["unknown"], compared["unfit"], compared["command"]) == ([], [], None)

    bench.link.weather = Weather(delay=0.2)
    loading = bench.api.post_text(bench.path + "/file", saved).json()["command"]
    wait_for("some are written", lambda: under_way(bench, loading["id"]), 30)
    bench.link.weather = CUT
    wait_for("the cut is felt", lambda: bench.api.drone(bench.drone)["link"]["state"] != "live", 10)
    bench.link.weather = CLEAR

    assert bench.api.ended(loading["id"], 90)["outcome"]["result"] == "succeeded"
    assert bench.station.parameters() == before
    assert bench.api.text(f"{bench.path}/file?form={form}") == saved


def under_way(bench: Bench, command: str) -> bool:
    record = bench.api.get(f"/commands/{command}")
    return bool(record["outcome"] or (record["progress"] and record["progress"]["done"] > 0))


@pytest.mark.soak
@pytest.mark.parametrize("bench", ["arducopter"], indirect=True)
def test_a_thousand_parameters_go_up_a_bad_link(bench: Bench) -> None:
    bench.read()
    names = [p["name"] for p in bench.api.get(bench.path + "?search=SPARE")["parameters"]]
    file = "\n".join(f"{name},{number % 120}" for number, name in enumerate(names))
    bench.link.weather = BAD

    loading = bench.api.post_text(bench.path + "/file", file).json()["command"]

    assert bench.api.ended(loading["id"], 600)["outcome"]["result"] == "succeeded"
    bench.link.weather = CLEAR
    held = bench.station.parameters()
    assert [held[name][0] for name in names] == [number % 120 for number in range(len(names))]
