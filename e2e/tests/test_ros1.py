"""Our bridge with the real packages of ROS 1 and a real server: what a robot shows, and what it is told."""

import math
import signal
import time
import zlib
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.helm import Helm
from dronemap_e2e.ros1 import Machine, Process, Ros, is_installed
from dronemap_e2e.server import Server
from dronemap_e2e.soap import soap
from dronemap_e2e.waiting import wait_for

pytestmark = pytest.mark.skipif(
    not is_installed(), reason="needs ros-core and python3-rospy, which ./dronemap test installs from Debian"
)

SYSTEM_ID = 3401
PICTURE = b"\xff\xd8\xff" + bytes(range(256)) * 80
FREE, OCCUPIED, UNKNOWN = 254, 0, 205


@dataclass
class Robot:
    machine: Machine
    bridge: Process
    drone: str


@pytest.fixture(scope="module")
def robot(server: Server, api: Api, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Robot]:
    issued = api.call("POST", "/robot-keys", {"label": "Of ROS", "systemId": SYSTEM_ID})
    assert issued.status_code == 201, issued.text
    folder = tmp_path_factory.mktemp("ros")
    picture = folder / "picture.jpg"
    picture.write_bytes(PICTURE)
    ros = Ros(folder)
    try:
        machine = ros.machine(picture)
        bridge = ros.bridge(server, SYSTEM_ID, issued.json()["key"])
        drone = wait_for("it is listed with all that it shows", lambda: shown(api))
        yield Robot(machine, bridge, drone["id"])
    finally:
        ros.stop()


def shown(api: Api) -> Json | None:
    """The robot, once all kinds of messages have come."""
    for drone in api.drones():
        if drone["link"]["systemId"] == SYSTEM_ID and drone["local"] and drone["battery"]:
            sensed = drone["sensed"] or {}
            return drone if sensed.get("scan") and sensed.get("picture") else None
    return None


def test_what_it_publishes_is_seen(api: Api, robot: Robot) -> None:
    drone = api.drone(robot.drone)
    assert drone["kind"] == "rover"
    assert drone["battery"]["percent"] == 83
    assert (drone["position"], drone["gps"]) == (None, None)
    assert api.content(f"/drones/{robot.drone}/sensed/picture") == PICTURE
    scan = api.get(f"/drones/{robot.drone}/sensed")["scan"]
    assert math.radians(scan["firstAngle"]) == pytest.approx(-1.5)
    assert math.radians(scan["angleStep"]) == pytest.approx(1)
    assert scan["ranges"] == [1.25, None, None, 2.5]

    api.do(robot.drone, type="readMap")
    area = api.get(f"/drones/{robot.drone}/sensed")["map"]
    assert (area["left"], area["bottom"], area["width"], area["height"]) == (-1, -2, 1.5, 1)
    lines = drawn(api.content(f"/drones/{robot.drone}/sensed/map"))
    assert lines == bytes([0, FREE, FREE, FREE, 0, FREE, OCCUPIED, UNKNOWN]), (
        "each begins with its filter, none"
    )


def drawn(png: bytes) -> bytes:
    """The lines of a small PNG."""
    start = png.index(b"IDAT") + 4
    return zlib.decompress(png[start : start + int.from_bytes(png[start - 8 : start - 4], "big")])


def test_it_is_driven_and_stands_when_nobody_steers(server: Server, api: Api, robot: Robot) -> None:
    before = api.drone(robot.drone)["local"]["x"]
    with closing(Helm(server, api.new_key("stick", "operator"), robot.drone)) as helm:
        wait_for("it is told to drive", lambda: robot.machine.forward == 0.4)
        wait_for("its odometry shows it", lambda: api.drone(robot.drone)["local"]["x"] > before + 0.2)
        assert api.drone(robot.drone)["motion"]["groundSpeed"] == pytest.approx(0.4, abs=0.01)
        began = time.monotonic()
        helm.cut()
        wait_for("it is told to stand", lambda: robot.machine.forward == 0, every=0.01)
        assert time.monotonic() - began < 1


def test_it_goes_to_a_place_and_gives_it_up_by_each_face(server: Server, api: Api, robot: Robot) -> None:
    api.do(robot.drone, type="goToLocal", x=2, y=-1)
    goal = robot.machine.told("goal")[-1]
    assert (goal["x"], goal["y"], goal["frame"]) == (2, -1, "map")
    api.do(robot.drone, type="emergencyStop")
    wait_for("the way is given up", lambda: robot.machine.told("cancel"))

    service = soap(server, server.local_key())
    assert service.goToLocal(robot.drone, 0, 1).result == "succeeded"
    assert (robot.machine.told("goal")[-1]["x"], robot.machine.told("goal")[-1]["y"]) == (0, 1)
    assert service.readMap(robot.drone).result == "succeeded"
    assert service.emergencyStop(robot.drone).result == "succeeded"
    wait_for("this way, too", lambda: len(robot.machine.told("cancel")) == 2)


def test_it_stands_when_the_bridge_is_ended(server: Server, api: Api, robot: Robot) -> None:
    """The last, as there is no bridge after it."""
    with closing(Helm(server, api.new_key("stick", "operator"), robot.drone)):
        wait_for("it is told to drive", lambda: robot.machine.forward == 0.4)
        robot.bridge.send_signal(signal.SIGTERM)
        began = time.monotonic()
        wait_for("it is told to stand", lambda: robot.machine.forward == 0, every=0.01)
        assert time.monotonic() - began < 1
        assert robot.bridge.wait(10) == 0
