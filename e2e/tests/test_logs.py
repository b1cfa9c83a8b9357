"""Logs on board: listed, fetched over a link that breaks in the middle, saved byte for byte."""

from pathlib import Path
from typing import Any

from dronemap_e2e.api import Api
from dronemap_e2e.impairer import CLEAR, CUT, Impairer, Weather
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

from .conftest import SYSTEM_IDS

LOSSY = Weather(delay=0.02, loss=0.1)


def test_a_log_goes_over_with_a_break_in_the_middle(server: Server, api: Api, tmp_path: Path) -> None:
    system_id = next(SYSTEM_IDS)
    link = Impairer(server.udp_port, seed=system_id)
    simulator = Simulator(tmp_path / "sim.log", f"udp://127.0.0.1:{link.port}", "--sysid", str(system_id))
    try:
        drone = wait_for("the vehicle is listed", lambda: _listed(api, system_id), 60)
        path = f"/drones/{drone}/logs"
        assert api.get(path) == {"logs": None}
        listing = api.call("POST", path + "/refresh").json()
        assert api.ended(listing["id"], 20)["outcome"]["result"] == "succeeded"
        assert [log["sizeBytes"] for log in api.get(path)["logs"]] == [12_345, 100_000]
        assert api.call("GET", path + "/2/file").status_code == 409

        link.weather = LOSSY
        fetching = api.call("POST", path + "/2/download").json()["id"]
        wait_for("some of it came", lambda: _came(api, fetching) > 10_000, 30)
        link.weather = CUT
        wait_for("the cut is felt", lambda: api.drone(drone)["link"]["state"] != "live", 10)
        link.weather = CLEAR
        assert api.ended(fetching, 90)["outcome"]["result"] == "succeeded"
        again = api.call("POST", path + "/2/download")
        assert again.status_code == 409

        # The log is always the same bytes: fetched anew, over a good link, it must be equal.
        first = _file(api, path)
        assert len(first) == 100_000
        assert api.call("DELETE", path + "/2/file").status_code == 204
        fetching = api.call("POST", path + "/2/download").json()["id"]
        assert api.ended(fetching, 60)["outcome"]["result"] == "succeeded"
        assert _file(api, path) == first
        assert api.get(path)["logs"][1]["here"]
    finally:
        simulator.stop()
        link.close()


def _file(api: Api, path: str) -> bytes:
    answer = api.call("GET", path + "/2/file")
    assert answer.ok, answer.text
    return answer.content


def _came(api: Api, command: str) -> int:
    progress: dict[str, Any] = api.get(f"/commands/{command}")["progress"] or {"done": 0}
    return int(progress["done"])


def _listed(api: Api, system_id: int) -> str | None:
    return next((str(d["id"]) for d in api.drones() if d["link"]["systemId"] == system_id), None)
