"""Missions over links that are bad, or break: what the vehicle holds is what was sent, or it is said."""

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

HOME = (47.3977, 8.5456)


@dataclass(frozen=True)
class Bench:
    """One simulated vehicle behind a link that a test may spoil, with a station plugged into it."""

    api: Api
    simulator: Simulator
    link: Impairer
    station: PluggedStation
    system_id: int
    drone: str

    def begin_upload(self, items: list[Json]) -> str:
        answer = self.api.call(
            "POST", f"/drones/{self.drone}/commands", {"type": "uploadMission", "items": items}
        )
        assert answer.status_code == 202, answer.text
        command: str = answer.json()["id"]
        return command

    def holds(self, items: list[Json]) -> bool:
        """Whether the vehicle itself has these waypoints in this order, whatever stands before them."""
        held = [(i.x, i.y, round(i.z)) for i in self.station.mission()]
        sent = [(round(i["latitude"] * 1e7), round(i["longitude"] * 1e7), i["altitude"]) for i in items]
        return held[-len(sent) :] == sent


@pytest.fixture(params=["arducopter", "px4"])
def bench(request: pytest.FixtureRequest, server: Server, api: Api, tmp_path: Path) -> Iterator[Bench]:
    system_id = next(SYSTEM_IDS)
    link = Impairer(server.udp_port, seed=system_id)
    simulator = Simulator(
        tmp_path / "sim.log",
        f"udp://127.0.0.1:{link.port}",
        *("--sysid", str(system_id), "--personality", request.param),
    )
    station = PluggedStation(link, system_id)
    drone = wait_for("the vehicle is ready", lambda: api.ready(system_id), 90)["id"]
    yield Bench(api, simulator, link, station, system_id, drone)
    simulator.stop()
    link.close()


def waypoints(count: int, seed: int = 0) -> list[Json]:
    return [
        {
            "type": "waypoint",
            "latitude": round(HOME[0] + (number + 1 + seed) * 1e-5, 7),
            "longitude": round(HOME[1] + (number % 7) * 2e-5, 7),
            "altitude": 20 + number % 30,
        }
        for number in range(count)
    ]


def test_a_link_that_breaks_at_any_item_only_delays_the_upload(bench: Bench) -> None:
    for number, done in enumerate((0, 3, 7, 11)):
        items = waypoints(12, seed=100 * number)
        bench.link.weather = Weather(delay=0.05)
        command = bench.begin_upload(items)
        wait_for("it is that far", lambda c=command, d=done: _done(bench, c) >= d, 20)  # type: ignore[misc]
        bench.link.weather = CUT
        wait_for("the cut is felt", lambda: bench.api.drone(bench.drone)["link"]["state"] != "live", 10)
        bench.link.weather = CLEAR

        outcome = bench.api.ended(command, 90)["outcome"]
        assert outcome["result"] == "succeeded", outcome
        assert bench.holds(items)


def _done(bench: Bench, command: str) -> int:
    record = bench.api.get(f"/commands/{command}")
    if record["outcome"]:
        return 10_000
    return int(record["progress"]["done"]) if record["progress"] else -1


def test_an_item_that_the_vehicle_silently_altered_is_told(bench: Bench) -> None:
    bench.simulator.fault(f"{bench.system_id} alter 4")

    record = bench.api.ended(bench.begin_upload(waypoints(8)), 60)

    assert record["outcome"]["result"] == "failed"
    assert "another mission than the one sent" in record["outcome"]["reason"]


@pytest.mark.parametrize(
    ("count", "seconds"),
    [(6, 120), pytest.param(200, 1800, marks=pytest.mark.soak)],
    ids=["6 items", "200 items"],
)
def test_a_mission_goes_up_a_bad_link(bench: Bench, count: int, seconds: float) -> None:
    items = waypoints(count)
    bench.link.weather = BAD

    outcome = bench.api.ended(bench.begin_upload(items), seconds)["outcome"]

    assert outcome["result"] == "succeeded", outcome
    bench.link.weather = CLEAR
    assert bench.holds(items)


def test_only_what_differs_goes_up_where_the_vehicle_takes_parts(bench: Bench) -> None:
    items = waypoints(30)
    assert bench.api.ended(bench.begin_upload(items), 60)["outcome"]["result"] == "succeeded"
    first_hash = bench.api.drone(bench.drone)["mission"]["hash"]
    assert first_hash
    items[7]["altitude"] = 44
    heard = bench.station.listen()

    assert bench.api.ended(bench.begin_upload(items), 60)["outcome"]["result"] == "succeeded"

    asked = {m.seq for m in heard() if m.get_type() in ("MISSION_REQUEST", "MISSION_REQUEST_INT")}
    partly = bench.api.drone(bench.drone)["autopilot"] == "ArduPilot"
    # Home stands before the items of an ArduPilot mission, and the cloud puts a take-off in front.
    assert asked == ({9} if partly else set(range(31)))
    assert bench.holds(items)
    assert bench.api.drone(bench.drone)["mission"]["hash"] not in (None, first_hash)


@pytest.mark.parametrize("count", [5, 80])
def test_a_change_by_somebody_else_is_noticed_and_told(bench: Bench, count: int) -> None:
    assert bench.api.ended(bench.begin_upload(waypoints(count)), 60)["outcome"]["result"] == "succeeded"
    assert bench.api.drone(bench.drone)["mission"]["notice"] is None

    bench.station.raise_item(4, 7)

    def notice() -> str | None:
        told: str | None = bench.api.drone(bench.drone)["mission"]["notice"]
        return told

    assert "differs" in wait_for("the change is told", notice, 120)
    assert any("differs" in m["text"] for m in bench.api.drone(bench.drone)["messages"])


def test_fence_and_rally_points_go_round(bench: Bench) -> None:
    path = f"/drones/{bench.drone}"
    corners = [
        {"latitude": 47.39, "longitude": 8.54},
        {"latitude": 47.41, "longitude": 8.54},
        {"latitude": 47.4, "longitude": 8.56},
    ]
    zones: list[Json] = [
        {"type": "polygon", "inside": True, "corners": corners, "center": None, "radius": None},
        {"type": "circle", "inside": False, "corners": None, "center": corners[0], "radius": 50.0},
    ]
    points = [{"latitude": 47.395, "longitude": 8.545, "altitude": 25.0}]
    assert bench.api.get(path + "/fence") == {"zones": None}

    _succeed(bench, "PUT", path + "/fence", {"zones": zones})
    _succeed(bench, "PUT", path + "/rally-points", {"points": points})

    assert bench.api.get(path + "/fence") == {"zones": zones}
    assert bench.api.get(path + "/rally-points") == {"points": points}
    assert [item.command for item in bench.station.mission(kind=1)] == [5001, 5001, 5001, 5004]
    assert [item.command for item in bench.station.mission(kind=2)] == [5100]
    broken = bench.api.call("PUT", path + "/fence", {"zones": [{"type": "circle", "inside": True}]})
    assert (broken.status_code, broken.json()["field"]) == (422, "zones[0].center.latitude")
    _succeed(bench, "DELETE", path + "/fence")
    _succeed(bench, "DELETE", path + "/rally-points")
    _succeed(bench, "POST", path + "/fence/refresh")
    assert bench.api.get(path + "/fence") == {"zones": []}
    assert bench.station.mission(kind=1) == bench.station.mission(kind=2) == []


def _succeed(bench: Bench, method: str, path: str, body: Json | None = None) -> None:
    answer = bench.api.call(method, path, body)
    assert answer.ok, answer.text
    outcome = bench.api.ended(answer.json()["id"], 30)["outcome"]
    assert outcome["result"] == "succeeded", outcome
