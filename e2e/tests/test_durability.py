"""What was acknowledged is there, however often the server is killed."""

import random
import threading
from collections.abc import Callable

import pytest
import requests

from dronemap_e2e.api import Api
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import wait_for

WRITERS = 4
ITEMS = [{"type": "waypoint", "latitude": 47.4, "longitude": 8.5, "altitude": 20}]


@pytest.mark.parametrize(
    ("writes", "kills"),
    [(300, 2), pytest.param(1_000, 4, marks=pytest.mark.soak)],
    ids=["some", "a thousand"],
)
def test_acknowledged_writes_survive_random_kills(writes: int, kills: int, killable: Server) -> None:
    """End to end because a process is killed with -9 under its clients, and its own PostgreSQL goes on."""
    chance = random.Random(20)
    acknowledged: list[str] = []
    for kill in range(kills):
        goal = writes * (kill + 1) // (kills + 1) + chance.randrange(50)
        _write_until(killable, acknowledged, goal, and_then=killable.kill)
        killable.start()
    _write_until(killable, acknowledged, writes)
    api = Api(killable.address, killable.local_key())
    kept = {mission["name"] for mission in api.get("/missions")["missions"]}

    assert len(acknowledged) >= writes
    assert set(acknowledged) <= kept


def _write_until(
    server: Server, acknowledged: list[str], goal: int, and_then: Callable[[], None] = lambda: None
) -> None:
    """Some clients write until enough was acknowledged; the server may be killed under them."""
    key, enough = server.local_key(), threading.Event()

    def write() -> None:
        api = Api(server.address, key)
        while _write(api, acknowledged) and not enough.is_set():
            pass

    writers = [threading.Thread(target=write) for _ in range(WRITERS)]
    for writer in writers:
        writer.start()
    wait_for("enough writes", lambda: len(acknowledged) >= goal, 60, every=0.01)
    and_then()
    enough.set()
    for writer in writers:
        writer.join(20)
        assert not writer.is_alive()


def _write(api: Api, acknowledged: list[str]) -> bool:
    name = f"mission {len(acknowledged)} {random.randrange(10**9)}"
    try:
        answer = api.call("POST", "/missions", {"name": name, "items": ITEMS})
    except requests.RequestException:
        return False
    if answer.status_code == 201:
        acknowledged.append(name)
    return answer.status_code == 201
