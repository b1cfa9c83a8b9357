"""The whole flight by curl-like REST, by SOAP and by WebSocket, judged from the wire."""

import json
import subprocess
from collections.abc import Callable
from typing import Any

from websockets.sync.client import ClientConnection, connect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point, items, judge, triangle
from dronemap_e2e.message_recorder import VehicleMessages
from dronemap_e2e.server import Server
from dronemap_e2e.soap import soap
from dronemap_e2e.waiting import wait_for

TAKE_OFF_METERS = 8.0


def fly(api: Api, drone: str, act: Callable[..., Json], points: list[Point]) -> None:
    """Arm, take off, three waypoints, home; `act` is the face under test, REST only watches."""
    act("arm")
    act("takeOff", altitude=TAKE_OFF_METERS)
    wait_for("it hovers", lambda: _altitude(api, drone) > TAKE_OFF_METERS - 1, 60)
    act("uploadMission", items=items(points))
    act("startMission")
    last = len(api.drone(drone)["mission"]["items"]) - 1
    wait_for("the last waypoint is reached", lambda: last in api.drone(drone)["mission"]["reached"], 120)
    act("returnToLaunch")
    wait_for("it landed and disarmed", lambda: api.drone(drone)["armed"] is False, 120)


def _altitude(api: Api, drone: str) -> float:
    altitude: float = api.drone(drone)["position"]["altitudeAboveHome"]
    return altitude


def test_flies_by_rest(api: Api, wire: VehicleMessages, copter: Json) -> None:
    """End to end because requests speaks HTTP to the server's own port, and the judge sees only the wire."""
    points = triangle(copter["home"])

    def act(kind: str, **body: Any) -> Json:
        return api.do(copter["id"], type=kind, **body)

    fly(api, copter["id"], act, points)

    judge(wire, points, TAKE_OFF_METERS)


def test_flies_by_curl(server: Server, api: Api, wire: VehicleMessages, copter: Json) -> None:
    """End to end because curl is the program that the handbook tells people to use."""
    points = triangle(copter["home"], altitude=6)

    def act(kind: str, **body: Any) -> Json:
        answer = subprocess.run(
            [
                *("curl", "-sS", "-X", "POST", "-H", f"Authorization: Bearer {server.local_key()}"),
                *("-H", "Content-Type: application/json", "-d", json.dumps({"type": kind} | body)),
                f"{server.address}/api/v1/drones/{copter['id']}/commands?wait=60",
            ],
            capture_output=True,
            check=True,
            timeout=70,
        )
        record: Json = json.loads(answer.stdout)
        assert record["outcome"]["result"] == "succeeded", record
        return record

    fly(api, copter["id"], act, points)

    judge(wire, points, 6)


def test_flies_by_soap(server: Server, api: Api, wire: VehicleMessages, copter: Json) -> None:
    """End to end because zeep makes its calls of the service's own WSDL."""
    points = triangle(copter["home"], altitude=10)
    service = soap(server, server.local_key())
    listed = [d.id for d in service.getDronesList().item]
    assert copter["id"] in listed

    def act(kind: str, **body: Any) -> Json:
        drone = copter["id"]
        command = {
            "arm": lambda: service.arm(droneId=drone),
            "takeOff": lambda: service.takeoff(droneId=drone, altitude=TAKE_OFF_METERS),
            "uploadMission": lambda: service.uploadMission(
                droneId=drone,
                items={
                    "item": [
                        {
                            "waypoint": {
                                "latitude": p.latitude,
                                "longitude": p.longitude,
                                "altitude": p.altitude,
                            }
                        }
                        for p in points
                    ]
                },
            ),
            "startMission": lambda: service.startMission(droneId=drone),
            "returnToLaunch": lambda: service.returnToLaunch(droneId=drone),
        }[kind]()
        assert command.outcome.result == "succeeded", command
        return {}

    fly(api, copter["id"], act, points)

    judge(wire, points, TAKE_OFF_METERS)


def test_flies_by_websocket(server: Server, api: Api, wire: VehicleMessages, copter: Json) -> None:
    """End to end because another maker's WebSocket client carries the whole flight."""
    points = triangle(copter["home"], altitude=7)
    headers = {"Authorization": f"Bearer {server.local_key()}"}
    # Without a bound: what nobody reads any more would keep its end waiting for as long as that may take.
    with connect(server.stream_address, additional_headers=headers, max_queue=None) as stream:

        def act(kind: str, **body: Any) -> Json:
            request = f"{kind}-1"
            stream.send(
                json.dumps(
                    {
                        "type": "command",
                        "requestId": request,
                        "drone": copter["id"],
                        "command": {"type": kind} | body,
                    }
                )
            )
            accepted = _next(stream, lambda m: m.get("requestId") == request)
            assert accepted["type"] == "commandAccepted", accepted
            ended = _next(
                stream,
                lambda m: (
                    m["type"] == "command"
                    and m["command"]["id"] == accepted["command"]["id"]
                    and m["command"]["outcome"] is not None
                ),
            )
            assert ended["command"]["outcome"]["result"] == "succeeded", ended
            record: Json = ended["command"]
            return record

        fly(api, copter["id"], act, points)

    judge(wire, points, 7)


def _next(stream: ClientConnection, wanted: Callable[[Json], bool]) -> Json:
    while True:
        message: Json = json.loads(stream.recv(timeout=60))
        if wanted(message):
            return message
