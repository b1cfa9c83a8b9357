"""Acknowledged writes survive kills of the server."""

import os
import random
import threading
from collections.abc import Callable

import pytest
import requests

from dronemap_e2e.api import Api
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import wait_for
from dronemap_e2e.writers import ITEMS, Writer, one_of_each_kind

WRITERS = 4
KILLS = int(os.environ.get("DRONEMAP_KILLS", "40"))
# Of each writer before a kill, so that each kill has something to lose.
LEAST_WRITES = 5
LONGEST_SECONDS_MORE = 2.0


@pytest.mark.parametrize(
    ("writes", "kills"),
    [(300, 2), pytest.param(1_000, 4, marks=pytest.mark.soak)],
    ids=["some", "a thousand"],
)
def test_acknowledged_writes_survive_random_kills(writes: int, kills: int, killable_server: Server) -> None:
    """End to end because a process is killed with -9 under its clients, and its own PostgreSQL goes on."""
    chance = random.Random(20)
    acknowledged: list[str] = []
    for kill in range(kills):
        goal = writes * (kill + 1) // (kills + 1) + chance.randrange(50)
        _write_until(killable_server, acknowledged, goal, and_then=killable_server.kill)
        killable_server.start()
    _write_until(killable_server, acknowledged, writes)
    api = Api(killable_server.address, killable_server.local_key())
    kept = {mission["name"] for mission in api.get("/missions")["missions"]}

    assert len(acknowledged) >= writes
    assert set(acknowledged) <= kept


@pytest.mark.soak
def test_four_writers_of_four_kinds_lose_nothing_in_forty_kills(own_server: Server) -> None:
    """End to end because a process is killed with -9 under its clients; each kill falls at another moment."""
    chance = random.Random(40)
    writers = one_of_each_kind()
    for kill in range(KILLS):
        _write_and_kill(own_server, writers, chance.uniform(0, LONGEST_SECONDS_MORE))
        own_server.start()
        api = Api(own_server.address, own_server.local_key())
        for writer in writers:
            writer.check(api)
        print(f"kill {kill + 1} of {KILLS}: of {[each.acknowledged for each in writers]} none is lost")


def _write_and_kill(server: Server, writers: list[Writer], seconds_more: float) -> None:
    enough, before = threading.Event(), [writer.acknowledged for writer in writers]
    threads = [threading.Thread(target=writer.write, args=(server, enough)) for writer in writers]

    def all_have_written() -> bool:
        assert [writer.refusal for writer in writers if writer.refusal] == []
        return all(
            writer.acknowledged >= first + LEAST_WRITES for writer, first in zip(writers, before, strict=True)
        )

    for thread in threads:
        thread.start()
    try:
        wait_for("each has written", all_have_written, 60, every=0.01)
        threads[0].join(seconds_more)
        server.kill()
    finally:
        enough.set()
        for thread in threads:
            thread.join(20)
            assert not thread.is_alive()


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
