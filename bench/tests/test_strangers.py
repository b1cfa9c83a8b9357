"""Checks that strangers can be run (short), the summary, and the goals (soak)."""

import socket
from typing import Any

import pytest

from dronemap_bench.programs import Json
from dronemap_bench.strangers import mavlink, report, trial, wire
from dronemap_bench.strangers.others import VEHICLES

# From many addresses: one that was cut a few times has to wait.
SMALL = trial.Options(
    rounds=1,
    warm_up_seconds=3,
    calm_seconds=2,
    megabytes=20,
    least_seconds=1,
    most_seconds=20,
    strangers=3,
    many_addresses=True,
)


@pytest.mark.soak
def test_endless_messages_are_cut_and_other_clients_go_on() -> None:
    result = trial.run(SMALL)
    summary = report.summary(result)
    assert set(summary["ports"]) == {"stream", "robots", "vehicles", trial.CONTROL}
    for name, port in summary["ports"].items():
        assert port["gigabytes"] > 0, (name, port)
        assert port["connections"] > SMALL.strangers, f"nobody was cut at {name}: {port}"
    assert result["liveVehiclesAtTheEnd"] == VEHICLES
    assert max(summary["ports"]["stream"]["heapMegabytes"]) < max(summary["calmHeapMegabytes"]) + 20
    assert "| vehicles |" in report.table(summary, {"processor": "p", "java": "j", "revision": "r"})


@pytest.mark.soak
@pytest.mark.parametrize("many_addresses", [True, False], ids=["two gigabytes", "from one address"])
def test_twenty_strangers_at_each_port_do_not_slow_other_clients(many_addresses: bool) -> None:
    result = trial.run(trial.Options(many_addresses=many_addresses))
    summary = report.summary(result)
    assert report.missed(summary, result, VEHICLES) == [], summary


def window(what: str, p99: float, heap: float = 50, gigabytes: float = 3) -> Json:
    late = {who: {"p99": p99} for who in trial.OTHERS}
    attack = {"bytes": gigabytes * 1e9, "connections": 9, "turnedAway": 0}
    shares = {"serverPercentOfOneCore": 1, "strangersPercentOfOneCore": 1, "elsePercentOfOneCore": 1}
    return {
        "what": what,
        "round": 1,
        "before": "stream",
        "late": late,
        "liveHeapMegabytes": heap,
        "attack": attack,
    } | shares


def ended(live: int) -> Json:
    return {"liveVehiclesAtTheEnd": live, "options": {"many_addresses": True}}


@pytest.mark.parametrize(
    ("attacked", "missed"),
    [
        ({"p99": 19}, []),
        ({"p99": 21}, ["stream: p99 of"] * len(trial.OTHERS)),
        ({"p99": 10, "heap": 71}, ["stream: the heap grew to 71 MB"]),
        ({"p99": 10, "gigabytes": 1.9}, ["stream: only 1.9 GB could be sent"]),
    ],
    ids=["met", "slow", "heap", "little sent"],
)
def test_missed_goals_are_named(attacked: dict[str, Any], missed: list[str]) -> None:
    calm = [window(trial.CALM, 10) | {"before": name} for name in ("stream", trial.CONTROL)]
    windows = [*calm, window("stream", **attacked), window(trial.CONTROL, 99, 99, 0)]
    found = report.missed(report.summary({"windows": windows}), ended(VEHICLES), VEHICLES)
    assert len(found) == len(missed)
    assert all(sentence.startswith(begin) for sentence, begin in zip(found, missed, strict=True))


def test_vehicle_lost_at_the_end_is_reported() -> None:
    summary = report.summary({"windows": [window(trial.CALM, 10)]})
    assert report.missed(summary, ended(VEHICLES - 1), VEHICLES) == ["9 of 10 vehicles were live at the end"]


@pytest.mark.parametrize("length", [0, 125, 126, 65_535, 65_536])
def test_websocket_frames_are_read_in_any_fragmentation(length: int) -> None:
    here, there = socket.socketpair()
    with here, there:
        reader = wire.Reader(there)
        masked = wire.frame(wire.BINARY, b"x" * length)
        head = len(masked) - length - 4
        # A server masks nothing.
        unmasked = masked[:1] + bytes([masked[1] & 0x7F]) + masked[2:head] + masked[head + 4 :]
        here.sendall(unmasked[:1])
        assert list(reader.frames()) == []
        here.sendall(unmasked[1:])
        found: list[bytes] = []
        while not found:
            found += reader.frames()
        assert found == [b"x" * length]


def test_heartbeat_is_found_after_other_frames() -> None:
    assert mavlink.has_heartbeat(mavlink.position(1, 2, 3, 4) + mavlink.heartbeat(1, 7))
    assert not mavlink.has_heartbeat(mavlink.position(1, 2, 3, 4))
