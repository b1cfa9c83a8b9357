"""Mission runs for tests: plans, stages and waypoints of a run, and the drones' tracks."""

import math

from .api import Api, Json
from .flight import EARTH_RADIUS_METERS
from .message_recorder import MessageRecorder
from .waiting import wait_for

Track = list[tuple[float, float, float]]


def ready_drone(api: Api, system_id: int) -> Json | None:
    """The drone, once all is known of it that a plan takes."""
    drone = api.ready(system_id)
    complete = drone and drone["battery"] and drone["link"]["quality"]["lossShort"] is not None
    return drone if complete else None


def create_plan(api: Api, drones: list[Json], waypoints: list[Json]) -> str:
    """A plan for all of them, once it is found."""
    asked = api.call(
        "POST",
        "/plans",
        {
            "drones": [drone["id"] for drone in drones],
            "waypoints": waypoints,
            "seconds": 1,
            "objective": {"kind": "earliestEnd", "everyDrone": True},
        },
    )
    assert asked.status_code == 202, asked.text
    plan: str = asked.json()["id"]
    wait_for("the plan is finished", lambda: api.get(f"/plans/{plan}")["state"] == "finished", 60)
    return plan


def stages(run: Json) -> dict[str, str]:
    return {drone["id"]: drone["stage"] for drone in run["drones"]}


def waypoints_in_state(run: Json, drone: str, state: str) -> list[Json]:
    """Its waypoints in that state."""
    return [
        one
        for one in run["waypoints"]
        if one["state"] == state and drone in (one["drone"], *(visit["drone"] for visit in one["visits"]))
    ]


def tracks(
    recorder: MessageRecorder, drones: list[Json], first_system_id: int, begin: int = 0
) -> dict[str, Track]:
    """Tracks from that report on, by the drones' own reports, also while no server listened."""
    flown: dict[str, Track] = {drone["id"]: [] for drone in drones}
    of_system = {first_system_id + n: drone["id"] for n, drone in enumerate(drones)}
    for recorded in recorder.messages("GLOBAL_POSITION_INT", up=True)[begin:]:
        message = recorded.message
        if message.get_srcSystem() in of_system:
            flown[of_system[message.get_srcSystem()]].append(
                (message.lat / 1e7, message.lon / 1e7, message.alt / 1e3)
            )
    return flown


def distance(waypoint: Json, track: Track) -> float:
    """Metres at which a drone came nearest to a waypoint, height included."""
    per_degree = math.radians(1) * EARTH_RADIUS_METERS
    east = per_degree * math.cos(math.radians(waypoint["latitude"]))
    return min(
        math.hypot(
            (latitude - waypoint["latitude"]) * per_degree,
            (longitude - waypoint["longitude"]) * east,
            altitude - waypoint["altitudeAmsl"],
        )
        for latitude, longitude, altitude in track
    )


def run_if_over(api: Api, run: str) -> Json | None:
    now = api.get(run)
    return now if now["state"] == "over" else None
