"""One stream serves many readers, over cuts."""

import asyncio
from typing import Any

import pytest

from dronemap import AsyncDronemap, Dronemap, DronemapError, Problem, WaitedTooLong
from dronemap.reader import Reader
from dronemap.stream import StateReader
from dronemap.testing import MockTransport


def test_several_read_the_same_and_none_takes_it_from_another(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    drone = server.drone()
    first, second = drone.states(), drone.states()
    assert next(first).mode == next(second).mode == "GUIDED"
    mock.change(id, mode="RTL")
    assert next(first).mode == "RTL"
    assert next(second).mode == "RTL"


def test_who_reads_late_gets_the_newest(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    drone = server.drone()
    states = drone.states()
    next(states)
    for mode in ("RTL", "LAND", "AUTO"):
        mock.change(id, mode=mode)
    drone.wait_for(lambda state: state.mode == "AUTO", 5)
    assert next(states).mode == "AUTO"


def test_readers_go_on_after_a_cut(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    drone = server.drone()
    states = drone.states()
    next(states)
    mock.cut()
    mock.change(id, mode="LAND")
    assert next(states).mode == "LAND"


def test_readers_go_on_after_the_server_was_away(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    states = server.drone().states()
    next(states)
    mock.go_away()
    mock.change(id, mode="LAND")
    mock.come_back()
    assert next(states).mode == "LAND"


def test_condition_that_does_not_come_true_ends_after_its_time(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    with pytest.raises(WaitedTooLong, match=r"alpha: .* within 0\.2 s"):
        server.drone().wait_for(lambda state: state.mode == "never", 0.2)


def test_key_that_is_not_good_ends_all_readers(mock: MockTransport) -> None:
    mock.add_drone("alpha")
    mock.answer("GET", "/settings", {"status": 401, "code": "not-signed-in", "detail": "Sign in first."}, 401)
    with Dronemap.connect(transport=mock) as server, pytest.raises(Problem, match="Sign in first"):
        next(server.drone().states())


def test_all_drones_are_told_and_then_what_changes(server: Dronemap, mock: MockTransport) -> None:
    ids = [mock.add_drone(name) for name in ("alpha", "beta")]
    changes = server.changes()
    assert {next(changes).name, next(changes).name} == {"alpha", "beta"}
    mock.change(ids[1], mode="LAND")
    changed = next(changes)
    assert (changed.id, changed.state.mode) == (ids[1], "LAND")


def test_drone_that_is_out_of_sight_is_forgotten() -> None:
    mock = MockTransport()
    id = mock.add_drone("alpha")

    async def seen() -> tuple[bool, bool]:
        async with AsyncDronemap.connect(transport=mock) as server:
            await server.stream.ready()
            before = id in server.stream.drones
            mock.tell({"type": "droneRemoved", "id": id})
            mock.tell({"type": "ping", "at": "2026-01-01T00:00:00Z"})
            messages = server.stream.messages(frozenset({"ping"}), None)
            await anext(messages)
            return before, id in server.stream.drones

    assert asyncio.run(seen()) == (True, False)


def test_reader_that_must_miss_nothing_and_does_not_read_is_told_so() -> None:
    async def read() -> Any:
        reader: Reader[int] = Reader(None, lambda _: None)
        for number in range(10_001):
            reader.put(number)
        return await anext(reader)

    with pytest.raises(DronemapError, match="More than 10000 changes"):
        asyncio.run(read())


def test_reader_that_is_closed_ends() -> None:
    async def read() -> list[int]:
        closed: list[Reader[int]] = []
        reader: Reader[int] = Reader(None, closed.append)
        reader.put(1)
        reader.close()
        assert closed == [reader]
        return [item async for item in reader]

    assert asyncio.run(read()) == [1]


def test_parts_of_a_state_that_stay_are_read_once() -> None:
    mock = MockTransport()
    drone = mock._drones[mock.add_drone("alpha", battery={"percent": 80, "further": []}, gps={"fix": "3D"})]
    reader = StateReader()
    first = reader.read(drone)
    second = reader.read(drone | {"battery": {"percent": 79, "further": []}, "mode": "RTL", "gps": {"fix": "3D"}})
    assert second.gps is first.gps
    assert second.battery is not None and second.battery.percent == 79
    assert (first.mode, second.mode) == ("GUIDED", "RTL")
    assert reader.read(drone | {"battery": None}).battery is None
