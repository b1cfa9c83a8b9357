"""Robots over ROSLink as drones of the cloud: listed, stopped and flown through REST, and each for itself."""

from collections.abc import Iterator

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.robot import ARM, TWIST, FlyingRobot, Robot
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import wait_for


def allowed(api: Api, system_id: int, action: str) -> Json:
    """That robot as the server lists it, once it may be told that."""

    def look() -> Json | None:
        found = [drone for drone in api.drones() if drone["link"]["systemId"] == system_id]
        return found[0] if found and found[0]["actions"][action]["allowed"] else None

    return wait_for(f"robot {system_id} is listed, and {action} is allowed", look)


@pytest.fixture
def rover(server: Server) -> Iterator[Robot]:
    """On a WebSocket, with its heartbeats over UDP as well; its key is a number."""
    address = f"ws://127.0.0.1:{server.robot_web_port}/websockets/roslink/user/12/robot/12/robot"
    robot = Robot(server.robot_udp_port, 3012, 12, address)
    yield robot
    robot.close()


@pytest.fixture
def flyer(server: Server) -> Iterator[FlyingRobot]:
    robot = FlyingRobot(server.robot_udp_port, 3026, "1243-0000-0000-FGFG")
    yield robot
    robot.close()


def test_a_rover_is_shown_on_its_own_map_and_stops_when_told_to(
    api: Api, rover: Robot, flyer: FlyingRobot
) -> None:
    drone = allowed(api, rover.system_id, "hold")
    wait_for("both of its links are known as one robot's", lambda: api.drone(drone["id"])["link"]["others"])
    shown = wait_for("it says where it is", lambda: (d := api.drone(drone["id"]))["local"] and d)
    assert shown["kind"] == "rover"
    assert shown["link"]["transport"] == "websocket"
    assert shown["local"]["y"] == 0.5
    assert (shown["position"], shown["battery"], shown["gps"], shown["armed"]) == (None, None, None, None)
    assert not shown["actions"]["takeOff"]["allowed"]
    allowed(api, flyer.system_id, "arm")

    # Whoever calls in is told to stand still first, until it reports that it does.
    wait_for("it was told to stand", lambda: len(rover.orders) >= 6)

    def driven() -> Json | None:
        """By somebody beside it, who drives on whatever it is told."""
        rover.speed = 0.4
        now = api.drone(drone["id"])
        return now if now["motion"]["groundSpeed"] > 0.3 else None

    moving = wait_for("it is seen to move", driven)
    assert moving["local"]["x"] >= 0
    api.do(drone["id"], type="hold")

    assert rover.speed == 0
    assert set(rover.orders) == {TWIST}
    assert flyer.orders == []


def test_a_drone_behind_mavros_is_flown(api: Api, flyer: FlyingRobot) -> None:
    drone = allowed(api, flyer.system_id, "arm")["id"]

    api.do(drone, type="arm")
    assert flyer.armed
    api.do(drone, type="takeOff", altitude=3)
    assert flyer.height > 2.5
    assert api.drone(drone)["mode"] == "GUIDED"
    api.do(drone, type="land")
    assert flyer.height == 0
    api.do(drone, type="disarm")
    assert not flyer.armed


def test_a_robot_that_ignores_an_order_is_never_said_to_have_followed_it(server: Server, api: Api) -> None:
    stubborn = FlyingRobot(server.robot_udp_port, 3099, "stubborn", obedient=False)
    try:
        drone = allowed(api, stubborn.system_id, "arm")["id"]
        ended = api.command(drone, {"type": "arm"})
    finally:
        stubborn.close()

    assert ended["outcome"]["result"] == "failed"
    assert "still disarmed" in ended["outcome"]["reason"]
    assert stubborn.orders.count(ARM) > 3
