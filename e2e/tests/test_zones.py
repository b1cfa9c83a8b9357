"""No-fly zones of the cloud: what is refused, what flies round them, and what happens in flight."""

from collections.abc import Iterator
from typing import Any

import pytest

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point, items
from dronemap_e2e.tap import Tap
from dronemap_e2e.waiting import wait_for

METERS_PER_DEGREE = 111_195.0
COS_47 = 0.68


def place(drone: Json, north: float, east: float) -> tuple[float, float]:
    """Metres from home, as latitude and longitude."""
    home = drone["home"]
    return (
        home["latitude"] + north / METERS_PER_DEGREE,
        home["longitude"] + east / METERS_PER_DEGREE / COS_47,
    )


def box(drone: Json, south: float, north: float, west: float, east: float, **properties: Any) -> Json:
    """A zone that binds this drone alone: the server is shared with other tests."""
    corners = [(south, west), (south, east), (north, east), (north, west), (south, west)]
    ring = [list(reversed(place(drone, *corner))) for corner in corners]
    return {
        "type": "Feature",
        "geometry": {"type": "Polygon", "coordinates": [ring]},
        "properties": {"name": "School", "drone": drone["id"]} | properties,
    }


@pytest.fixture
def zones(api: Api, copter: Json) -> Iterator[list[str]]:
    """Adds what a test leaves here to the list of what is taken away at its end."""
    added: list[str] = []
    yield added
    for zone in added:
        assert api.call("DELETE", f"/zones/{zone}").status_code == 204


def add(api: Api, zones: list[str], zone: Json) -> str:
    answer = api.call("POST", "/zones", zone)
    assert answer.status_code == 201, answer.text
    added: str = answer.json()["id"]
    zones.append(added)
    return added


def north_of_home(api: Api, drone: Json) -> float:
    now = api.drone(drone["id"])["position"]["latitude"]
    metres: float = (now - drone["home"]["latitude"]) * METERS_PER_DEGREE
    return metres


def take_off(api: Api, drone: Json, altitude: float = 10) -> None:
    api.do(drone["id"], type="setMode", mode="GUIDED")
    api.do(drone["id"], type="arm")
    api.do(drone["id"], type="takeOff", altitude=altitude)
    wait_for("it is up", lambda: api.drone(drone["id"])["position"]["altitudeAboveHome"] > altitude - 1, 60)


def says(api: Api, drone: Json, words: str) -> bool:
    return any(words in message["text"] for message in api.drone(drone["id"])["messages"])


def mission(drone: Json, *points: tuple[float, float]) -> list[Json]:
    return items([Point(*place(drone, *point), 10) for point in points])


def test_a_mission_through_a_zone_is_refused_and_one_round_it_flies(
    api: Api, tap: Tap, copter: Json, zones: list[str]
) -> None:
    add(api, zones, box(copter, 30, 60, -20, 20))
    through = mission(copter, (90, 0), (90, 40))
    round_it = mission(copter, (0, 50), (90, 50), (90, 0))

    refused = api.command(copter["id"], {"type": "uploadMission", "items": through})

    assert (refused["outcome"]["result"], refused["outcome"]["by"]) == ("refused", "gate")
    # The take-off, put in front by the server, is item 1.
    sentence = "The way from item 1 to item 2 enters the no-fly zone “School” after 30 m."
    assert refused["outcome"]["reason"] == sentence
    assert not tap.heard("MISSION_COUNT", up=False), "something of it was sent"

    api.do(copter["id"], type="uploadMission", items=round_it)
    take_off(api, copter)
    api.do(copter["id"], type="startMission")
    last = len(api.drone(copter["id"])["mission"]["items"]) - 1
    wait_for("it is round", lambda: last in api.drone(copter["id"])["mission"]["reached"], 120)

    home_again = {"type": "goTo", **dict(zip(("latitude", "longitude"), place(copter, 0, 0), strict=True))}
    through_it = api.command(copter["id"], home_again | {"altitude": 10})
    assert "enters the no-fly zone “School” after 30 m" in through_it["outcome"]["reason"]
    api.do(copter["id"], type="returnToLaunch")
    wait_for(
        "who returns through it is warned", lambda: says(api, copter, "It returns all the same, but"), 30
    )
    wait_for("it landed", lambda: api.drone(copter["id"])["armed"] is False, 120)


def test_a_breach_is_warned_of_before_and_acted_on(api: Api, copter: Json, zones: list[str]) -> None:
    take_off(api, copter)
    latitude, longitude = place(copter, 400, 0)
    api.do(copter["id"], type="goTo", latitude=latitude, longitude=longitude, altitude=10)
    # Put in its way while it flies: nothing but the watch in flight can stop it now.
    wait_for("it is on its way", lambda: north_of_home(api, copter) > 5, 60)
    add(api, zones, box(copter, 150, 300, -50, 50, onBreach="hold"))

    wait_for("it is warned", lambda: says(api, copter, "If it goes on like this it enters"), 60)
    assert north_of_home(api, copter) < 150, "the warning came with the breach"
    wait_for("it is told to hold", lambda: says(api, copter, "is told: hold"), 60)
    held = wait_for("it holds", lambda: _by_safety(api, copter), 60)

    assert (held["type"], held["by"], held["outcome"]["result"]) == ("hold", "zones", "succeeded")
    wait_for("it stands", lambda: (api.drone(copter["id"])["motion"]["groundSpeed"] or 0) < 0.5, 60)
    # Still in the zone: a second at three times 5 m/s is 15 m, and slow machines are given more.
    assert 150 <= north_of_home(api, copter) < 290
    onward = api.command(
        copter["id"], {"type": "goTo", "latitude": latitude, "longitude": longitude, "altitude": 10}
    )
    assert "begins inside the no-fly zone “School”" in onward["outcome"]["reason"]
    api.do(copter["id"], type="returnToLaunch")
    wait_for("it landed", lambda: api.drone(copter["id"])["armed"] is False, 120)


def test_a_zone_that_is_put_over_a_drone_sends_it_home(api: Api, copter: Json, zones: list[str]) -> None:
    take_off(api, copter)

    add(api, zones, box(copter, -40, 40, -40, 40, onBreach="returnToLaunch", floor=5))

    sent = wait_for("it is sent home", lambda: _by_safety(api, copter), 30)
    assert sent["type"] == "returnToLaunch"
    wait_for("it landed", lambda: api.drone(copter["id"])["armed"] is False, 120)


def _by_safety(api: Api, drone: Json) -> Json | None:
    """The newest command that the zones gave, once it has ended."""
    commands: list[Json] = api.get(f"/drones/{drone['id']}/commands")["commands"]
    return next((c for c in commands if c["face"] == "safety" and c["outcome"]), None)
