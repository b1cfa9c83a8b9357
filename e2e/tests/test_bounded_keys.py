"""An access key for an area and heights, on a drone that flies."""

import json

from websockets.sync.client import connect

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point, items
from dronemap_e2e.server import Server
from dronemap_e2e.soap import soap
from dronemap_e2e.tap import Tap
from dronemap_e2e.waiting import wait_for

METERS_PER_DEGREE = 111_195.0
CIRCLE_METERS = 150
CEILING_METERS = 30
DO_REPOSITION = 192
BEYOND = "leaves the bounds of this access key after"


def key_made_by(maker: Api, **wanted: object) -> Json:
    answer = maker.call("POST", "/access-keys", {"label": "field"} | wanted)
    assert answer.status_code == 201, answer.text
    made: Json = answer.json()
    return made


def test_what_a_bounded_key_commands_stays_in_its_area_and_heights_by_every_face(
    server: Server, api: Api, tap: Tap, copter: Json
) -> None:
    drone, home = copter["id"], copter["home"]

    def north(meters: float, altitude: float = 10) -> Point:
        return Point(home["latitude"] + meters / METERS_PER_DEGREE, home["longitude"], altitude)

    def go_to(meters: float, altitude: float = 10) -> Json:
        point = north(meters, altitude)
        return {
            "type": "goTo",
            "latitude": point.latitude,
            "longitude": point.longitude,
            "altitude": point.altitude,
        }

    def refusal(by: Api, command: Json) -> str:
        record = by.command(drone, command)
        assert (record["outcome"]["result"], record["outcome"]["by"]) == ("refused", "gate"), record
        why: str = record["outcome"]["reason"]
        return why

    circle = {
        "type": "Point",
        "coordinates": [home["longitude"], home["latitude"]],
        "radius": CIRCLE_METERS,
    }
    made = key_made_by(api, area=circle, ceiling=CEILING_METERS, operations=["view", "plan", "command"])
    field = Api(server.address, made["key"])

    # Never wider: not the area, not the heights; what is left out is inherited.
    for wider, member in (({"area": circle | {"radius": 151}}, "area"), ({"ceiling": 31}, "ceiling")):
        answer = field.call("POST", "/access-keys", {"label": "child"} | wider)
        assert (answer.status_code, answer.json()["field"]) == (422, member), answer.text
    child = key_made_by(field, area=circle | {"radius": 60})
    assert child["ceiling"] == CEILING_METERS
    near = Api(server.address, child["key"])

    field.do(drone, type="setMode", mode="GUIDED")
    field.do(drone, type="arm")
    ceiling = f"over the ceiling of the bounds of this access key at {CEILING_METERS} m above home"
    assert ceiling in refusal(field, {"type": "takeOff", "altitude": 40})
    field.do(drone, type="takeOff", altitude=10)
    wait_for("it is up", lambda: api.drone(drone)["position"]["altitudeAboveHome"] > 9, 60)

    assert BEYOND in refusal(field, go_to(200))
    assert BEYOND in refusal(near, go_to(100))
    assert ceiling in refusal(near, go_to(20, 40))
    through = items([north(50), north(200), north(20)])
    assert BEYOND in refusal(field, {"type": "uploadMission", "items": through})
    outside = north(200)
    outcome = soap(server, made["key"]).goto(drone, outside.latitude, outside.longitude, 10)
    assert (outcome.result, outcome.by) == ("refused", "gate")
    assert BEYOND in outcome.reason
    headers = {"Authorization": f"Bearer {made['key']}"}
    with connect(server.stream_address, additional_headers=headers) as stream:
        stream.send(json.dumps({"type": "command", "requestId": "r", "drone": drone, "command": go_to(200)}))
        while (told := json.loads(stream.recv(timeout=60))).get("requestId") != "r":
            pass
    assert BEYOND in json.dumps(told, ensure_ascii=False)
    assert not tap.heard("MISSION_COUNT", up=False), "something of a mission was sent"
    assert not _sent_somewhere(tap), "a go-to was sent"

    field.do(drone, **go_to(100))
    assert _sent_somewhere(tap)
    wait_for("it is out of the child's reach", lambda: _north(api, drone, home) > 65, 60)
    field.do(drone, type="uploadMission", items=items([north(50), north(120)]))
    # Whoever was let in further may go on; the child may still call it home.
    near.do(drone, type="returnToLaunch")
    wait_for("it landed", lambda: api.drone(drone)["armed"] is False, 120)


def _sent_somewhere(tap: Tap) -> bool:
    return any(
        heard.kind == "SET_POSITION_TARGET_GLOBAL_INT" or heard.message.command == DO_REPOSITION
        for heard in tap.heard("SET_POSITION_TARGET_GLOBAL_INT", "COMMAND_INT", up=False)
    )


def _north(api: Api, drone: str, home: Json) -> float:
    meters: float = (api.drone(drone)["position"]["latitude"] - home["latitude"]) * METERS_PER_DEGREE
    return meters
