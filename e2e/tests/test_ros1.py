"""Our bridge with the real packages of ROS 1 and a real server: a robot's data, and its orders."""

import math
import signal
import zlib
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.ros1 import Process, RobotProcess, Ros, is_installed
from dronemap_e2e.server import Server
from dronemap_e2e.soap import soap
from dronemap_e2e.steering_client import SteeringClient
from dronemap_e2e.waiting import wait_for

pytestmark = pytest.mark.skipif(
    not is_installed(), reason="needs ros-core and python3-rospy, which ./dronemap test installs from Debian"
)

SYSTEM_ID, COPTER_ID = 3401, 3402
PICTURE = b"\xff\xd8\xff" + bytes(range(256)) * 80
FREE, OCCUPIED, UNKNOWN = 254, 0, 205


@dataclass
class Robot:
    process: RobotProcess
    bridge: Process
    drone: str


@pytest.fixture(scope="module")
def ros(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Ros]:
    started = Ros(tmp_path_factory.mktemp("ros"))
    yield started
    started.stop()


@pytest.fixture(scope="module")
def robot(server: Server, api: Api, ros: Ros, tmp_path_factory: pytest.TempPathFactory) -> Robot:
    picture = tmp_path_factory.mktemp("picture") / "picture.jpg"
    picture.write_bytes(PICTURE)
    process = ros.robot(picture)
    bridge = ros.bridge(server, SYSTEM_ID, issue_robot_key(api, SYSTEM_ID))
    drone = wait_for("it is listed with all that it shows", lambda: robot_with_all_data(api))
    return Robot(process, bridge, drone["id"])


def issue_robot_key(api: Api, system_id: int) -> str:
    answer = api.call("POST", "/robot-keys", {"label": "Of ROS", "systemId": system_id})
    assert answer.status_code == 201, answer.text
    return str(answer.json()["key"])


def robot_with_all_data(api: Api) -> Json | None:
    """The robot, once all kinds of messages have come."""
    for drone in api.drones():
        if drone["link"]["systemId"] == SYSTEM_ID and drone["local"] and drone["battery"]:
            sensed = drone["sensed"] or {}
            return drone if sensed.get("scan") and sensed.get("picture") else None
    return None


def check_published_data(api: Api, robot: Robot) -> None:
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
    lines = png_lines(api.content(f"/drones/{robot.drone}/sensed/map"))
    assert lines == bytes([0, FREE, FREE, FREE, 0, FREE, OCCUPIED, UNKNOWN]), (
        "each begins with its filter, none"
    )


def check_position(api: Api, robot: Robot) -> None:
    """Its odometry says that it is at (0.5, 1.5) and turned a quarter to the right."""

    def is_there() -> bool:
        local = api.drone(robot.drone)["local"]
        return [local["x"], local["y"], local["yaw"]] == pytest.approx([0, 0, 0], abs=0.01)

    wait_for("AMCL has said where it is", is_there)


def png_lines(png: bytes) -> bytes:
    """The lines of a small PNG."""
    start = png.index(b"IDAT") + 4
    return zlib.decompress(png[start : start + int.from_bytes(png[start - 8 : start - 4], "big")])


def check_driving(server: Server, api: Api, robot: Robot) -> None:
    before = api.drone(robot.drone)["local"]["x"]
    with closing(SteeringClient(server, api.new_key("stick", "operator"), robot.drone)) as steering:
        wait_for("it is told to drive", lambda: robot.process.forward == 0.4)
        wait_for("its odometry shows it", lambda: api.drone(robot.drone)["local"]["x"] > before + 0.2)
        assert api.drone(robot.drone)["motion"]["groundSpeed"] == pytest.approx(0.4, abs=0.01)
        steering.cut()
        wait_for("it is told to stand", lambda: robot.process.forward == 0, every=0.01)


def check_goal(server: Server, api: Api, robot: Robot) -> None:
    api.do(robot.drone, type="goToLocal", x=2, y=-1)
    goal = robot.process.orders("goal")[-1]
    assert (goal["x"], goal["y"], goal["frame"]) == (2, -1, "map")
    api.do(robot.drone, type="emergencyStop")
    wait_for("the way is given up", lambda: robot.process.orders("cancel"))

    service = soap(server, server.local_key())
    assert service.goToLocal(droneId=robot.drone, x=0, y=1).outcome.result == "succeeded"
    assert (robot.process.orders("goal")[-1]["x"], robot.process.orders("goal")[-1]["y"]) == (0, 1)
    assert service.readMap(droneId=robot.drone).outcome.result == "succeeded"
    assert service.emergencyStop(droneId=robot.drone).outcome.result == "succeeded"
    wait_for("this way, too", lambda: len(robot.process.orders("cancel")) == 2)


def test_copter_behind_mavros_is_flown(server: Server, api: Api, ros: Ros) -> None:
    """End to end because the packages of ROS 1, and our bridge between them and us, are real programs."""
    copter = ros.copter("copter")
    key = issue_robot_key(api, COPTER_ID)
    ros.bridge(server, COPTER_ID, key, "--mavros", namespace="copter")

    def listed() -> Json | None:
        found = [d for d in api.drones() if d["link"]["systemId"] == COPTER_ID]
        last = ("gps", "mode", "local", "battery", "position")
        complete = found and all(found[0][one] for one in last)
        return found[0] if complete and found[0]["position"]["altitudeAmsl"] is not None else None

    drone = wait_for("it is listed with all that it shows", listed)
    assert drone["kind"] == "multicopter"
    assert (drone["battery"]["percent"], drone["battery"]["volts"]) == (80, pytest.approx(12.1))
    assert drone["mode"] == "STABILIZE"
    place = drone["position"]
    assert (place["latitude"], place["longitude"], place["altitudeAmsl"]) == (47.4, 8.5, 410)
    assert math.radians(drone["local"]["yaw"]) == pytest.approx(0.5)

    identity = drone["id"]
    api.do(identity, type="arm")
    api.do(identity, type="takeOff", altitude=3)
    assert (copter.orders("mode")[-1]["name"], copter.orders("take off")[-1]["height"]) == ("GUIDED", 3)
    assert api.drone(identity)["position"]["altitudeAboveHome"] > 2.5
    with closing(SteeringClient(server, api.new_key("stick", "operator"), identity, 1.0)):
        wait_for("it flies ahead", lambda: api.drone(identity)["local"]["y"] > 0.3)
        last = copter.orders("speeds")[-1]
        assert (last["forward"], last["frame"], last["mask"]) == (1, 8, 0b0101_1100_0111)
    wait_for("it is told to stand", lambda: copter.orders("speeds")[-1]["forward"] == 0, every=0.01)
    api.do(identity, type="land")
    wait_for("it is down", lambda: api.drone(identity)["position"]["altitudeAboveHome"] < 0.1)
    api.do(identity, type="disarm")
    assert [one["wanted"] for one in copter.orders("arm")][-1] is False
    assert not api.drone(identity)["armed"]


def check_stop_at_end(server: Server, api: Api, robot: Robot) -> None:
    """It is told to stand."""
    with closing(SteeringClient(server, api.new_key("stick", "operator"), robot.drone)):
        wait_for("it is told to drive", lambda: robot.process.forward == 0.4)
        robot.bridge.send_signal(signal.SIGTERM)
        wait_for("it is told to stand", lambda: robot.process.forward == 0, every=0.01)
        assert robot.bridge.wait(10) == 0


def test_ros1_robot_is_shown_driven_sent_and_stopped(server: Server, api: Api, robot: Robot) -> None:
    """End to end because the packages of ROS 1, and our bridge between them and us, are real programs."""
    check_published_data(api, robot)
    check_position(api, robot)
    check_driving(server, api, robot)
    check_goal(server, api, robot)
    check_stop_at_end(server, api, robot)
