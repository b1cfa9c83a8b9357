"""Stores what a version has while much is under way, for the test that later versions take it up.

    python -m dronemap_e2e.upgrade FOLDER

writes it into FOLDER with the jars that are built in this checkout; docs/how-to-add/version.md says when.
"""

import json
import secrets
import shutil
import sys
import tempfile
import time
from datetime import UTC, datetime
from functools import partial
from pathlib import Path

from .api import Api, Json
from .flight import Point, flight_of, items, triangle
from .followed_phones import FollowedPhone
from .runs import create_plan, ready_drone, stages
from .server import Server
from .simulator import Simulator
from .waiting import wait_for
from .walker import beside

FIRST_SYSTEM_ID = 1
RUN, FOLLOW, VIRTUAL, HELD = slice(0, 2), 2, 3, 4
COUNT = 5
HEIGHT = 20
# So that all are under way together for long, and yet nobody waits for long.
SPEEDUP = "2"
TOGETHER_SECONDS = 12
KEPT_SECONDS = 2
PASSWORD = "a password of the fixture"
# The database itself is in the backup: as text, which every later PostgreSQL reads.
LEFT_OUT = {"postgres", "server.log"}


def create(api: Api, path: str, body: Json) -> Json:
    answer = api.call("POST", path, body)
    assert answer.status_code in (200, 201, 202), f"{path}: {answer.text}"
    body_of_answer: Json = answer.json()
    return body_of_answer


def change(api: Api, method: str, path: str, body: Json | None = None) -> None:
    answer = api.call(method, path, body)
    assert answer.ok, f"{path}: {answer.text}"


def create_people(server: Server, api: Api) -> Api:
    """An operator with a password of his own, of whom an administrator set the first one."""
    first = secrets.token_hex(10)
    create(api, "/users", {"name": "pilot", "password": first, "role": "operator"})
    pilot = Api(server.address)
    change(pilot, "POST", "/session", {"name": "pilot", "password": first})
    change(pilot, "POST", "/session/password", {"current": first, "next": PASSWORD})
    create(api, "/invitations", {"label": "a guest", "role": "viewer"})
    create(api, "/organisations", {"name": "Surveyors"})
    return pilot


def create_rights(api: Api, pilot: Api, drones: list[Json]) -> Json:
    """Keys, grants and what seals them; what is shown only once is what this answers."""
    home = drones[0]["home"]
    circle = {"type": "Point", "coordinates": [home["longitude"], home["latitude"]], "radius": 500}
    key = create(pilot, "/access-keys", {"label": "field", "area": circle, "ceiling": 60})
    narrow = {"label": "one drone", "drones": [drones[0]["id"]], "operations": ["view", "command"]}
    create(pilot, "/access-keys", narrow)
    group = create(api, "/groups", {"name": "crew", "members": ["pilot"]})
    fleet = create(api, "/fleets", {"name": "roofs", "drones": [drones[0]["id"], drones[1]["id"]]})
    create(api, "/grants", {"group": group["id"], "fleet": fleet["id"], "operations": ["view", "plan"]})
    create(api, "/grants", {"user": "pilot", "all": True, "operations": ["view", "plan", "command"]})
    robot = create(api, "/robot-keys", {"label": "a robot", "systemId": 7, "owner": "26"})
    passphrase = pilot.call("PUT", "/outlet/passphrase", {}).json()["passphrase"]
    dtls = create(api, "/dtls-keys", {"label": "a copter"})
    link = create(api, f"/drones/{drones[VIRTUAL]['id']}/link-key", {})
    return {
        "accessKey": key["key"],
        "robotKey": robot["id"],
        "passphrase": passphrase,
        "dtlsKey": dtls["identity"],
        "linkKey": link["key"],
    }


def create_zones(api: Api, home: Json, drone: Json) -> None:
    place = [home["longitude"], home["latitude"]]
    away = [place[0] + 0.02, place[1]]
    square = [
        [away[0] + east, away[1] + north] for east, north in ((0, 0), (0.002, 0), (0.002, 0.002), (0, 0))
    ]
    circle = {"type": "Point", "coordinates": away}
    area = {"type": "Polygon", "coordinates": [square]}
    for geometry, properties in (
        (circle, {"name": "mast", "kind": "exclusion", "radius": 50, "onBreach": "hold"}),
        (area, {"name": "school", "kind": "exclusion", "until": "2099-01-01T00:00:00Z", "user": "pilot"}),
        (
            {"type": "Point", "coordinates": place},
            {"name": "field", "kind": "inclusion", "radius": 3000, "ceiling": 120, "drone": drone["id"]},
        ),
    ):
        create(api, "/zones", {"type": "Feature", "geometry": geometry, "properties": properties})


def record_flight(api: Api, drone: Json) -> None:
    """A flight that is over, with its recording."""
    api.do(drone["id"], type="setMode", mode="GUIDED")
    api.do(drone["id"], type="arm")
    api.do(drone["id"], type="takeOff", altitude=5)
    api.do(drone["id"], type="land")
    wait_for("it is down", lambda: flight_of(api, drone["id"], "ended"), 60)

    def kept() -> bool:
        return all(
            one["state"] != "running" for one in api.get(f"/recordings?drone={drone['id']}")["recordings"]
        )

    wait_for("its recording is kept", kept, 60)


def waypoints(home: Json) -> list[Json]:
    """Enough of them that the run goes on while the others begin; at some, something is done."""
    places = [beside(home, 40 * (n % 4), 60 + 40 * (n // 4)) for n in range(16)]
    return [
        {
            "latitude": place.latitude,
            "longitude": place.longitude,
            "altitude": home["altitudeAmsl"] + HEIGHT,
            "altitudeReference": "amsl",
        }
        | ({"tasks": [{"type": "photo"}]} if n % 5 == 0 else {})
        for n, place in enumerate(places)
    ]


def start_run(api: Api, drones: list[Json]) -> str:
    plan = create_plan(api, drones, waypoints(drones[0]["home"]))
    begun = create(api, "/runs", {"plan": plan, "name": "roofs", "onCloudLoss": "continue"})
    return str(begun["id"])


def start_virtual_drones(api: Api, pilot: Api, drone: Json) -> tuple[str, str]:
    """One that flies, and one that waits for a drone."""
    corners: list[Point] = triangle(drone["home"], altitude=30, side=150)
    ids = [
        create(pilot, "/virtual-drones", {"name": name, "items": items(corners)})["id"]
        for name in ("Survey", "Second survey")
    ]
    for one in ids:
        create(pilot, f"/virtual-drones/{one}/start", {})
    change(api, "PUT", f"/warehouse/{drone['id']}")
    return ids[0], ids[1]


def hold_control(pilot: Api, drone: Json) -> None:
    """A drone that hovers under a person's control, taken on purpose."""
    pilot.do(drone["id"], type="setMode", mode="GUIDED")
    pilot.do(drone["id"], type="arm")
    pilot.do(drone["id"], type="takeOff", altitude=5)
    create(pilot, f"/drones/{drone['id']}/control/take", {})
    until = time.monotonic() + KEPT_SECONDS
    wait_for("its mode is kept with who has it", lambda: time.monotonic() > until)


def under_way(api: Api, pilot: Api, drones: list[Json]) -> Json:
    given_up, follow = (
        FollowedPhone(FIRST_SYSTEM_ID + FOLLOW, drones[FOLLOW], HEIGHT, 600) for _ in range(2)
    )
    given_up.request_follow(pilot)
    given_up.request(pilot, "cancel")
    follow.request_follow(pilot)
    follow.request(pilot, "start")
    flies, waits = start_virtual_drones(api, pilot, drones[VIRTUAL])
    mission = start_run(pilot, drones[RUN])

    def together() -> bool:
        follow.send_position(pilot)
        now = api.get(f"/runs/{mission}")
        return (
            set(stages(now).values()) == {"flying"}
            and now["counts"]["visited"] > 0
            and api.get(f"/follows/{follow.follow}")["state"] == "tracking"
            and api.get(f"/virtual-drones/{flies}")["run"]["state"] == "flying"
        )

    wait_for("a run, a follow and a virtual drone's mission are under way together", together, 180)
    barrier = triangle(drones[0]["home"], side=-900)
    ring = [[corner.longitude, corner.latitude] for corner in (*barrier, barrier[0])]
    create(
        pilot,
        f"/runs/{mission}/barriers",
        {
            "type": "Feature",
            "geometry": {"type": "Polygon", "coordinates": [ring]},
            "properties": {"name": "a crane"},
        },
    )
    until = time.monotonic() + TOGETHER_SECONDS

    def gone_on() -> bool:
        follow.send_position(pilot)
        return time.monotonic() > until

    wait_for("they go on", gone_on, 2 * TOGETHER_SECONDS)
    hold_control(pilot, drones[HELD])
    return {"run": mission, "follow": follow.follow, "virtualDrone": flies, "waitingVirtualDrone": waits}


def keep(server: Server, api: Api, folder: Path, facts: Json) -> None:
    """Files first: a backup may hold more than them, as after a crash, and never less."""
    folder.mkdir(parents=True)
    shutil.copytree(server.data, folder / "data", ignore=lambda _, names: LEFT_OUT & set(names))
    receipt = api.get("/audit/receipt")
    (folder / "receipt.json").write_text(json.dumps(receipt, indent=4) + "\n")
    (folder / "backup.zip").write_bytes(api.call("POST", "/backup").content)
    facts["moment"] = datetime.now(UTC).isoformat().replace("+00:00", "Z")
    (folder / "facts.json").write_text(json.dumps(facts, indent=4) + "\n")


def store(folder: Path) -> None:
    with tempfile.TemporaryDirectory() as temporary:
        server = Server(Path(temporary) / "data", copy_initial_data=False)
        server.start()
        connect = f"udp://127.0.0.1:{server.udp_port}"
        options = ("--count", str(COUNT), "--speedup", SPEEDUP, "--sysid", str(FIRST_SYSTEM_ID))
        simulator = Simulator(Path(temporary) / "sim.log", connect, *options)
        try:
            api = Api(server.address, server.local_key())
            ids = range(FIRST_SYSTEM_ID, FIRST_SYSTEM_ID + COUNT)
            drones = [wait_for("a copter is known", partial(ready_drone, api, one), 120) for one in ids]
            pilot = create_people(server, api)
            shown = create_rights(api, pilot, drones)
            home = drones[0]["home"]
            create_zones(api, home, drones[0])
            create(pilot, "/missions", {"name": "roof", "items": items(triangle(home))})
            record_flight(pilot, drones[FOLLOW])
            facts = {
                "account": {"name": "pilot", "password": PASSWORD},
                "shown": shown,
                "held": drones[HELD]["id"],
                "underWay": under_way(api, pilot, drones),
            }
            keep(server, api, folder, facts)
        finally:
            server.kill()
            simulator.stop()


if __name__ == "__main__":
    store(Path(sys.argv[1]))
