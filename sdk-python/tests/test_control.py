"""Control lasts for its block, and nobody's drone is left in the air by leaving it."""

import asyncio
from typing import Any

import pytest

from dronemap import AsyncDronemap, ControlLost, Dronemap
from dronemap.control import OnExit
from dronemap.testing import MockTransport


def controls(mock: MockTransport) -> list[str]:
    return [f"{method} {path.partition('/control')[2]}" for method, path, _ in mock.requests if "/control" in path]


def test_control_is_taken_and_given_back(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    with server.drone().control() as drone:
        drone.arm()
        drone.disarm()
    assert controls(mock) == ["POST /take", "DELETE "]
    assert [command["epoch"] for command in mock.commands] == [1, 1]


@pytest.mark.parametrize(
    ("on_exit", "last"),
    [("return_home", "returnToLaunch"), ("land", "land"), ("hold", "hold"), ("keep", "takeOff")],
)
def test_drone_in_the_air_is_told_what_to_do(server: Dronemap, mock: MockTransport, on_exit: OnExit, last: str) -> None:
    mock.add_drone("alpha")
    with server.drone().control(on_exit=on_exit) as drone:
        drone.arm()
        drone.take_off(10)
    assert mock.commands[-1]["type"] == last
    assert controls(mock)[-1] == "DELETE "


def test_returning_home_is_what_happens_unless_said_otherwise(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    with pytest.raises(ZeroDivisionError), server.drone().control() as drone:
        drone.take_off(10)
        _ = 1 / 0
    assert mock.commands[-1]["type"] == "returnToLaunch"


def test_drone_that_cannot_be_told_is_given_back_all_the_same(server: Dronemap, mock: MockTransport) -> None:
    mock.add_drone("alpha")
    with pytest.raises(Exception, match="No fix"), server.drone().control() as drone:
        drone.take_off(10)
        mock.refuse("returnToLaunch", "no-position", "No fix.")
    assert controls(mock)[-1] == "DELETE "


def test_control_that_was_lost_commands_nothing_more(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha", flight="inAir")
    with server.drone().control() as drone:
        refused = {"status": 409, "code": "control-held", "detail": "Bea has control."}
        mock.answer("POST", f"/drones/{id}/control/heartbeat", refused, 409)
        _until_heartbeat(server, mock)
        with pytest.raises(ControlLost, match="Bea has control"):
            drone.land()
    assert "land" not in [command["type"] for command in mock.commands]
    assert "DELETE " not in controls(mock)


def test_server_that_cannot_answer_for_now_ends_no_control(mock: MockTransport) -> None:
    id = mock.add_drone("alpha", flight="inAir")
    with Dronemap.connect(transport=mock, patience=0.2) as server, server.drone().control() as drone:
        away = {"status": 503, "code": "store-away", "detail": "The store is away."}
        mock.answer("POST", f"/drones/{id}/control/heartbeat", away, 503)
        _until_heartbeat(server, mock)
        drone.land()
    assert mock.commands[-1]["type"] == "land"
    assert controls(mock)[-1] == "DELETE "


def test_drone_whose_take_off_the_stream_did_not_tell_returns_home(server: Dronemap, mock: MockTransport) -> None:
    id = mock.add_drone("alpha")
    with server.drone().control():
        mock._drones[id] |= {"flight": "inAir"}
    assert mock.commands[-1]["type"] == "returnToLaunch"


@pytest.mark.parametrize(
    ("flight", "armed", "told"),
    [("takingOff", True, True), ("landing", True, False), (None, True, True), (None, False, False)],
)
def test_only_what_is_up_is_told_to_return(
    server: Dronemap, mock: MockTransport, flight: str | None, armed: bool, told: bool
) -> None:
    mock.add_drone("alpha", flight=flight, armed=armed)
    with server.drone().control():
        pass
    assert [command["type"] for command in mock.commands] == ["returnToLaunch"] * told


def _until_heartbeat(server: Dronemap, mock: MockTransport) -> None:
    async def answered() -> None:
        async with asyncio.timeout(10):
            while not any("heartbeat" in path for _, path, _ in mock.requests):
                await asyncio.sleep(0.01)
            await asyncio.sleep(0)

    server._loop.run(answered())


def test_cancelled_program_brings_its_drone_home() -> None:
    mock = MockTransport()
    mock.add_drone("alpha")

    async def program() -> None:
        async with AsyncDronemap.connect(transport=mock) as server, (await server.drone()).control() as drone:
            await drone.take_off(10)
            await asyncio.Event().wait()

    async def cancelled() -> Any:
        task = asyncio.create_task(program())
        while not any(command["type"] == "takeOff" for command in mock.commands):
            await asyncio.sleep(0.01)
        task.cancel()
        return (await asyncio.gather(task, return_exceptions=True))[0]

    assert isinstance(asyncio.run(cancelled()), asyncio.CancelledError)
    assert mock.commands[-1]["type"] == "returnToLaunch"
