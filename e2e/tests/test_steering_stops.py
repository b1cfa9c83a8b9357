"""When who steered has gone, or may no more, a robot that repeats its last speeds stands in a second."""

import json
import threading
import time
from collections.abc import Callable, Iterator

import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.ground import User, granted
from dronemap_e2e.impairer import Impairer, Weather
from dronemap_e2e.robot import Robot
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import throughout, wait_for

MOST_SECONDS = 1.0
OFTEN = 0.005
TENTH_LOST = Weather(loss=0.1)
SYSTEM_ID = 3301


class Page:
    """Steers as the page does, ten times a second; once cut, it says nothing and closes nothing."""

    def __init__(self, server: Server, key: str, drone: str) -> None:
        headers = {"Authorization": f"Bearer {key}"}
        self._stream: ClientConnection = connect(server.stream_address, additional_headers=headers)
        self._setpoint = json.dumps({"type": "steer", "drone": drone, "velocity": {"forward": 0.4}})
        self._cut = threading.Event()
        self._thread = threading.Thread(target=self._steer, daemon=True)
        self._thread.start()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        """Without a reader the stream is called too slow and closed."""
        try:
            for _ in self._stream:
                pass
        except (ConnectionClosed, OSError):
            return

    def _steer(self) -> None:
        while not self._cut.wait(0.1):
            self._stream.send(self._setpoint)

    def cut(self) -> None:
        self._cut.set()
        self._thread.join()

    def kill(self) -> None:
        """As an operating system ends a program: its connection breaks without a word."""
        self.cut()
        self._stream.socket.close()

    def close(self) -> None:
        self.cut()
        self._stream.close()


@pytest.fixture(scope="module")
def robot(server: Server) -> Iterator[Robot]:
    link = Impairer(server.robot_udp_port, 7, TENTH_LOST)
    made = Robot(link.port, SYSTEM_ID, "forever")
    yield made
    made.close()
    link.close()


@pytest.fixture(scope="module")
def drone(api: Api, robot: Robot) -> Json:
    return wait_for(
        "the robot is listed and may be steered",
        lambda: next(
            (
                d
                for d in api.drones()
                if d["link"]["systemId"] == robot.system_id and d["actions"]["velocity"]["allowed"]
            ),
            None,
        ),
    )


@pytest.mark.parametrize("times", [1, pytest.param(25, marks=pytest.mark.soak)])
@pytest.mark.parametrize("end", ["page killed", "network cut", "lease taken", "grant revoked"])
def test_it_stands_within_a_second(
    server: Server, api: Api, robot: Robot, drone: Json, end: str, times: int
) -> None:
    pilot = granted(server, api, "operator", [drone["id"]])
    chief = granted(server, api, "supervisor", [drone["id"]])
    key = pilot.api.new_key("page", "operator")
    took: list[float] = []
    for number in range(times):
        page = Page(server, key, drone["id"])
        wait_for(f"it moves, {number}", lambda: robot.speed > 0.3, every=OFTEN)
        acts: dict[str, Callable[[], None]] = {
            "page killed": page.kill,
            "network cut": page.cut,
            "lease taken": lambda: take_over(chief, drone["id"]),
            "grant revoked": lambda: revoke(api, pilot.name),
        }
        began = time.monotonic()
        acts[end]()
        wait_for(f"it stands, {number}", lambda: robot.speed == 0, every=OFTEN)
        took.append(time.monotonic() - began)
        throughout("it stands", lambda: robot.speed == 0, 0.4, every=OFTEN)
        page.close()
        give_back(api, chief, pilot, drone["id"], end)
    print(f"{end}: {times} times, the longest {max(took):.2f} s of {sorted(round(one, 2) for one in took)}")
    assert max(took) <= MOST_SECONDS, took


def take_over(chief: User, drone: str) -> None:
    answer = chief.api.call("POST", f"/drones/{drone}/control/take-over", {"reason": "a child on the floor"})
    assert answer.ok, answer.text


def revoke(api: Api, name: str) -> None:
    for grant in api.get("/grants")["grants"]:
        if grant["user"] == name:
            assert api.call("DELETE", f"/grants/{grant['id']}").status_code == 204


def give_back(api: Api, chief: User, pilot: User, drone: str, end: str) -> None:
    if end == "lease taken":
        assert chief.api.call("DELETE", f"/drones/{drone}/control").ok
    if end == "grant revoked":
        body = {"user": pilot.name, "drones": [drone], "operations": ["view", "command"]}
        assert api.call("POST", "/grants", body).status_code == 201
    wait_for("it can be steered anew", lambda: free(chief.api.drone(drone), pilot.name))


def free(drone: Json, user: str) -> bool:
    return bool(drone["control"]["state"] == "free" or drone["control"]["holder"] == user)
