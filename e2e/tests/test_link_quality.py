"""What the server says of the links themselves: loss, round trips, and silence that is its own."""

import contextlib
import os
import signal
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.peer import OBEDIENT, Peer
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import throughout, wait_for

ANSWER_SECONDS = 0.06
STANDSTILL_SECONDS = 10


class Lossy:
    """Swallows every n-th message after it was numbered, as a bad link would."""

    def __init__(self, peer: Peer, every: int) -> None:
        self._peer = peer
        self._every = every
        self._count = 0

    def write(self, data: bytes) -> None:
        self._count += 1
        if self._count % self._every:
            self._peer.write(data)


def answer_late(peer: Peer, message: Any) -> None:
    if message.tc1 != 0:
        return

    def answer() -> None:
        # The test may be over by then.
        with contextlib.suppress(OSError):
            peer.link.timesync_send(time.monotonic_ns(), message.ts1)

    threading.Timer(ANSWER_SECONDS, answer).start()


def chatter(peer: Peer, stop: threading.Event) -> None:
    while not stop.wait(0.02):
        peer.link.attitude_send(0, 0.1, 0.2, 0.3, 0, 0, 0)


@pytest.fixture
def talkative(server: Server) -> Iterator[Peer]:
    peer = Peer(server.udp_port, system_id=211, handlers={**OBEDIENT, "TIMESYNC": answer_late})
    stop = threading.Event()
    talk = threading.Thread(target=chatter, args=(peer, stop))
    talk.start()
    yield peer
    stop.set()
    talk.join()
    peer.close()


def quality_of(api: Api, peer: Peer) -> Json | None:
    for drone in api.drones():
        if drone["link"]["port"] == peer.port:
            quality: Json = drone["link"]["quality"]
            return quality
    return None


def test_loss_and_round_trip_are_measured(api: Api, talkative: Peer) -> None:
    def known() -> Json | None:
        quality = quality_of(api, talkative)
        return quality if quality and None not in quality.values() else None

    good = wait_for("the quality is known", known, 20)
    # A busy machine may lose a datagram even on loopback.
    assert good["lossShort"] < 0.05 and good["lossLong"] < 0.05
    assert ANSWER_SECONDS * 1000 <= good["rttMs"] < 400

    talkative.link.file = Lossy(talkative, 4)

    def bad() -> Json | None:
        quality = known()
        return quality if quality and quality["lossShort"] > 0.18 else None

    quality = wait_for("a quarter is seen lost", bad, 20)
    assert quality["lossShort"] < 0.3
    assert 0 < quality["lossLong"] < quality["lossShort"]

    talkative.link.file = talkative
    wait_for("the short view forgets", lambda: (known() or good)["lossShort"] < 0.05, 30)
    assert (quality_of(api, talkative) or {})["lossLong"] > 0.02


def test_a_vehicle_that_asks_for_the_time_is_told_it(api: Api, talkative: Peer) -> None:
    wait_for("the drone is listed", lambda: quality_of(api, talkative), 30)

    def answered() -> list[int]:
        talkative.link.timesync_send(0, 4711)
        return [m.tc1 for m in talkative.received("TIMESYNC") if m.ts1 == 4711 and m.tc1 != 0]

    first = wait_for("the question is answered", answered, 30)[0]
    assert answered()[-1] >= first > 0


def stands_still(server: Server) -> bool:
    """Stopped, as /proc tells it behind the name in parentheses."""
    return Path(f"/proc/{server.pid}/stat").read_text().rpartition(") ")[2].startswith("T")


def test_nobody_is_called_lost_while_the_server_itself_stood_still(tmp_path: Path) -> None:
    server = Server(tmp_path / "data")
    server.start()
    peers = [Peer(server.udp_port, system_id=220 + i) for i in range(4)]
    peers += [Peer(server.tcp_port, system_id=230, tcp=True)]
    try:
        api = Api(server.address, server.local_key())

        def all_live() -> bool:
            drones = api.drones()
            return len(drones) == len(peers) and all(d["link"]["state"] == "live" for d in drones)

        wait_for("all are live", all_live, 30)
        os.kill(server.pid, signal.SIGSTOP)
        wait_for("the server stands still", lambda: stands_still(server), 10)
        # Ten seconds by the clock are the thing tested: twice the silence after which a drone is called lost.
        throughout("the server stands still", lambda: stands_still(server), STANDSTILL_SECONDS)
        os.kill(server.pid, signal.SIGCONT)

        def nobody_lost() -> bool:
            return all(d["link"]["state"] != "lost" for d in api.drones())

        throughout("nobody is called lost", nobody_lost, 8)
        texts = [m["text"] for d in api.drones() for m in d["messages"]]
        assert "Contact lost." not in texts
        assert all_live()

        # The watchdog itself is still awake.
        peers[0].silent = True
        wait_for("the silent one is lost", lambda: any(d["link"]["state"] == "lost" for d in api.drones()), 8)
        assert sum(d["link"]["state"] == "lost" for d in api.drones()) == 1
    finally:
        for peer in peers:
            peer.close()
        server.stop()
