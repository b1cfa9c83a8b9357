"""One command for a whole fleet: one outcome for each drone."""

import secrets
from collections.abc import Iterator

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import wait_for

FLEET = 20


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Api]:
    """A server with twenty simulated copters that may be armed."""
    folder = tmp_path_factory.mktemp("fleet")
    server = Server(folder / "data")
    server.start()
    simulator = Simulator(
        folder / "sim.log",
        f"udp://127.0.0.1:{server.udp_port}",
        *("--count", str(FLEET), "--sysid", "1"),
    )
    api = Api(server.address, server.local_key())

    def all_ready() -> bool:
        return all(api.ready(system_id) for system_id in range(1, FLEET + 1))

    wait_for("all may be armed", all_ready, 150, every=1)
    yield api
    simulator.stop()
    server.stop()


def give(api: Api, drones: object, command: Json, wait: int = 60, **more: object) -> Json:
    answer = api.call("POST", f"/commands?wait={wait}", {"drones": drones, "command": command, **more})
    assert answer.status_code in (200, 202), answer.text
    body: Json = answer.json()
    return body


def test_twenty_drones_give_twenty_outcomes(fleet: Api) -> None:
    ids = [d["id"] for d in fleet.drones()]
    assert len(ids) == FLEET

    armed = give(fleet, "all", {"type": "arm"})

    assert sorted(r["drone"] for r in armed["results"]) == sorted(ids)
    assert [r["command"]["outcome"]["result"] for r in armed["results"]] == ["succeeded"] * FLEET
    assert len({r["command"]["id"] for r in armed["results"]}) == FLEET


def test_each_drone_answers_for_itself(fleet: Api) -> None:
    first, second, *_ = sorted(d["id"] for d in fleet.drones())
    give(fleet, [first, second], {"type": "arm"})
    give(fleet, [first], {"type": "disarm"})

    mixed = give(fleet, [second, first, "nobody"], {"type": "disarm"})

    assert [r["drone"] for r in mixed["results"]] == [second, first, "nobody"]
    assert mixed["results"][0]["command"]["outcome"]["result"] == "succeeded"
    refused = mixed["results"][1]["command"]["outcome"]
    assert (refused["result"], refused["by"]) == ("refused", "gate")
    assert mixed["results"][2]["command"] is None
    assert mixed["results"][2]["problem"] == "There is no drone nobody."


def test_the_same_id_acts_once_on_each_drone(fleet: Api) -> None:
    ids = sorted(d["id"] for d in fleet.drones())[2:5]
    give(fleet, ids, {"type": "disarm"})
    name = "once-" + secrets.token_hex(8)

    first = give(fleet, ids, {"type": "arm"}, id=name)
    second = give(fleet, ids, {"type": "arm"}, id=name)

    assert first["id"] == second["id"] == name
    assert [r["command"] for r in first["results"]] == [r["command"] for r in second["results"]]


@pytest.mark.parametrize(
    ("body", "field"),
    [
        ({"command": {"type": "arm"}}, "drones"),
        ({"drones": [], "command": {"type": "arm"}}, "drones"),
        ({"drones": "all"}, "command"),
        ({"drones": "all", "command": {"type": "takeOff"}}, "command.altitude"),
        ({"drones": "all", "command": {"type": "fly"}}, "command.type"),
        ({"drones": "all", "command": {"type": "arm"}, "id": "x"}, "id"),
    ],
)
def test_bad_input_is_sent_to_nobody(fleet: Api, body: Json, field: str) -> None:
    before = [len(fleet.get(f"/drones/{d['id']}/commands")["commands"]) for d in fleet.drones()]

    answer = fleet.call("POST", "/commands", body)

    assert answer.status_code == 422 and answer.json()["field"] == field, answer.text
    after = [len(fleet.get(f"/drones/{d['id']}/commands")["commands"]) for d in fleet.drones()]
    assert before == after
