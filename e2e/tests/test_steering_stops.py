"""A robot that repeats its last speeds stops within a second of each end of steering."""

import time
from collections.abc import Callable, Iterator
from contextlib import closing

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.ground_station import User, granted
from dronemap_e2e.impairer import Impairer, LinkConditions
from dronemap_e2e.robot import Robot
from dronemap_e2e.server import Server
from dronemap_e2e.steering_client import SteeringClient
from dronemap_e2e.waiting import throughout, wait_for

MOST_SECONDS = 1.0
OFTEN = 0.005
TENTH_LOST = LinkConditions(loss=0.1)
SYSTEM_ID = 3301


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


@pytest.mark.soak
@pytest.mark.parametrize("times", [25])
@pytest.mark.parametrize("end", ["page killed", "network cut", "lease taken", "grant revoked"])
def test_robot_stops_within_a_second(
    server: Server, api: Api, robot: Robot, drone: Json, end: str, times: int
) -> None:
    pilot = granted(server, api, "operator", [drone["id"]])
    chief = granted(server, api, "supervisor", [drone["id"]])
    key = pilot.api.new_key("page", "operator")
    took: list[float] = []
    for number in range(times):
        with closing(SteeringClient(server, key, drone["id"])) as steering:
            wait_for(f"it moves, {number}", lambda: robot.speed > 0.3, every=OFTEN)
            acts: dict[str, Callable[[], None]] = {
                "page killed": steering.kill,
                "network cut": steering.cut,
                "lease taken": lambda: take_over(chief, drone["id"]),
                "grant revoked": lambda: revoke(api, pilot.name),
            }
            began = time.monotonic()
            acts[end]()
            wait_for(f"it stands, {number}", lambda: robot.speed == 0, every=OFTEN)
            took.append(time.monotonic() - began)
            throughout("it stands", lambda: robot.speed == 0, 0.4, every=OFTEN)
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
    if end == "grant revoked":
        body = {"user": pilot.name, "drones": [drone], "operations": ["view", "command"]}
        assert api.call("POST", "/grants", body).status_code == 201
    holder = chief.api.drone(drone)["control"]["holder"]
    if holder:
        # It would keep it for half a minute.
        user = chief if holder == chief.name else pilot
        assert user.api.call("DELETE", f"/drones/{drone}/control").ok
    wait_for("it can be steered anew", lambda: chief.api.drone(drone)["control"]["state"] == "free")
