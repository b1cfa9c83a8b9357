"""Bad input: a sentence that helps, the same one through each face, and nothing on the wire."""

import re
from typing import Any

import pytest
import zeep.exceptions
from requests import Session

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server
from dronemap_e2e.soap import soap
from dronemap_e2e.tap import Hears, Wire

WAYPOINT = {"type": "waypoint", "latitude": 47.4, "longitude": 8.5, "altitude": 20}


def sent(tap: Hears) -> list[Any]:
    """Commands and mission items that went down to the vehicle, message requests aside."""
    return [
        h.message
        for h in tap.heard("COMMAND_LONG", "COMMAND_INT", "MISSION_COUNT", "MISSION_ITEM_INT", up=False)
        if getattr(h.message, "command", None) not in (511, 512, 519, 520)
    ]


@pytest.mark.parametrize(
    ("body", "field", "words"),
    [
        (
            {
                "type": "uploadMission",
                "items": [WAYPOINT, {"type": "waypoint", "latitude": 47, "longitude": 8}],
            },
            r"items\[1\]\.altitude",
            "altitude",
        ),
        ({"type": "goTo", "latitude": 95, "longitude": 8, "altitude": 20}, "latitude", "-90 to 90"),
        ({"type": "goTo", "latitude": 47, "longitude": 181, "altitude": 20}, "longitude", "-180 to 180"),
        ({"type": "takeOff", "altitude": 0}, "altitude", "1 to 500"),
        ({"type": "takeOff", "altitude": "high"}, "altitude", "number"),
        ({"type": "takeOff"}, "altitude", "altitude"),
        ({"type": "fly"}, "type", "takeOff"),
        ({"type": "uploadMission", "items": []}, "items", "1 to 500"),
    ],
    ids=str,
)
def test_bad_values_name_the_field_and_the_range(
    api: Api, wire: Wire, copter: Json, body: Json, field: str, words: str
) -> None:
    answer = api.call("POST", f"/drones/{copter['id']}/commands", body)

    assert answer.status_code == 422, answer.text
    assert answer.headers["Content-Type"].startswith("application/problem+json")
    problem = answer.json()
    assert re.fullmatch(field, problem["field"]), problem
    assert words in problem["detail"] + str(problem.get("allowed")), problem
    assert not sent(wire)


def test_an_unknown_drone_is_not_found(api: Api) -> None:
    answer = api.call("POST", "/drones/nosuchdrone/commands", {"type": "arm"})

    assert answer.status_code == 404
    assert "nosuchdrone" in answer.json()["detail"]


def test_a_wrong_key_is_told_so(server: Server) -> None:
    answer = Api(server.address, "wrong").call("GET", "/drones")

    assert answer.status_code == 401
    assert "key" in answer.json()["detail"]


def test_a_viewer_may_look_but_not_arm(server: Server, api: Api, wire: Wire, copter: Json) -> None:
    viewer = Api(server.address, api.new_key("a viewer", "viewer"))
    assert viewer.drones()

    answer = viewer.call("POST", f"/drones/{copter['id']}/commands", {"type": "arm"})

    assert answer.status_code == 403
    assert "operator" in answer.json()["detail"]
    assert not sent(wire)


def test_broken_json_is_told_where_it_breaks(server: Server, copter: Json) -> None:
    session = Session()
    session.headers["Authorization"] = f"Bearer {server.local_key()}"
    answer = session.post(
        f"{server.address}/api/v1/drones/{copter['id']}/commands",
        data='{"type": "arm"',
        headers={"Content-Type": "application/json"},
        timeout=10,
    )

    assert answer.status_code == 400
    assert "line" in answer.json()["detail"]
    assert "Exception" not in answer.text


def test_soap_says_the_same_sentences(server: Server, api: Api, wire: Wire, copter: Json) -> None:
    service = soap(server, server.local_key())
    rest = api.call(
        "POST",
        f"/drones/{copter['id']}/commands",
        {"type": "goTo", "latitude": 95, "longitude": 8, "altitude": 20},
    ).json()["detail"]

    with pytest.raises(zeep.exceptions.Fault) as latitude:
        service.goto(copter["id"], 95, 8, 20)
    with pytest.raises(zeep.exceptions.Fault) as unknown:
        service.arm("nosuchdrone")

    assert latitude.value.message == rest
    assert latitude.value.code.endswith(":Client")
    assert "nosuchdrone" in unknown.value.message
    assert not sent(wire)


def test_soap_refuses_a_wrong_key_and_a_viewer(server: Server, api: Api, wire: Wire, copter: Json) -> None:
    for key, words in (("wrong", "key"), (api.new_key("soap viewer", "viewer"), "operator")):
        service = soap(server, key)
        with pytest.raises(zeep.exceptions.Fault) as fault:
            service.arm(copter["id"])
        assert words in fault.value.message
    assert not sent(wire)
