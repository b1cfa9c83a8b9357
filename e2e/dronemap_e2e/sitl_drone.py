"""A drone whose vehicle is a real autopilot in software: commanded over REST, judged by its true position."""

import contextlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from .api import Api, Json
from .flight import Point
from .proofs import Proofs
from .server import Server
from .sitl import Autopilot, Firmware
from .waiting import wait_for

HOME = (47.3977, 8.5456, 488.0)
READY_SECONDS = 120
FLIGHT_SECONDS = 240
# Nothing that is flown here leaves it.
FENCE_METRES = 3000


class SitlDrone:
    """One autopilot and its drone on a server."""

    def __init__(self, server: Server, api: Api, autopilot: Autopilot, drone: str, proofs: Proofs) -> None:
        self.server = server
        self.api = api
        self.autopilot = autopilot
        self.id = drone
        self.proofs = proofs
        self.proved = proofs.add

    def state(self) -> Json:
        return self.api.drone(self.id)

    def do(self, **body: Any) -> Json:
        return self.api.do(self.id, **body)

    def keep(self, what: str, body: Json) -> None:
        """Has the vehicle keep it, such as its fence."""
        answer = self.api.call("PUT", f"/drones/{self.id}/{what}", body)
        assert answer.ok, answer.text
        record = self.api.ended(answer.json()["id"], 60)
        assert record["outcome"]["result"] == "succeeded", record

    def refused(self, **body: Any) -> str:
        """The sentence by which it is refused, before or by the vehicle."""
        answer = self.api.call("POST", f"/drones/{self.id}/commands?wait=60", body)
        said: Json = answer.json()
        if answer.ok:
            assert said["outcome"]["result"] in ("refused", "failed"), said
            return str(said["outcome"]["reason"])
        assert answer.status_code in (409, 422), answer.text
        return str(said["detail"])

    def cannot(self, job: str, word: str, **body: Any) -> None:
        """It is refused in a sentence with that word, and the table says so."""
        sentence = self.refused(**body)
        assert word in sentence.lower(), sentence
        self.proved(job, "no")

    def keeps_on_board(self, parameter: tuple[str, float], point: Point) -> None:
        """What it stores, each read back by the server: a parameter, a rally point, a fence, and its logs."""
        self.do(type="readParameters")
        self.keep(f"parameters/{parameter[0]}", {"value": parameter[1]})
        self.proved("Parameters")
        self.keep("rally-points", {"points": [_where(point)]})
        self.proved("Rally points")
        around = {"type": "circle", "inside": True, "radius": FENCE_METRES, "center": _home()}
        self.keep("fence", {"zones": [around]})
        self.proved("Fence on board")
        self.do(type="readLogs")
        self.proved("Flight logs")
        self.do(type="takePicture")
        self.do(type="setRelay", relay=0, setting="on")
        self.proved("Picture, relay")

    def moves_home(self) -> None:
        """A metre north, above the sea, and back."""
        moved = place(1, 0)
        for point in (moved, place(0, 0)):
            where = {"latitude": point.latitude, "longitude": point.longitude}
            self.do(type="setHome", **where, altitude=HOME[2], altitudeReference="amsl")
            self.has_home(point)
        self.proved("Home moved")

    def has_home(self, point: Point) -> None:
        def is_there(drone: Json) -> bool:
            home = drone["home"]
            return point.metres_to(home["latitude"], home["longitude"]) < 0.2

        self.until("its home is there", is_there, 20)

    def until(self, what: str, look: Callable[[Json], object], seconds: float = FLIGHT_SECONDS) -> Json:
        """The state once that is so of it."""
        seen: list[Json] = []

        def now() -> bool:
            seen.append(self.state())
            return bool(look(seen[-1]))

        try:
            wait_for(what, now, seconds)
        except AssertionError as error:
            last = seen[-1]
            texts = [message["text"] for message in last["messages"]]
            raise AssertionError(f"{error}; mode {last['mode']}, {last['position']}, {texts}") from None
        return seen[-1]

    def becomes_ready(self) -> None:
        self.until("it says that it may be armed", lambda d: d["readyToArm"] and d["home"], READY_SECONDS)

    def height(self) -> float:
        """Truly, above where it started."""
        return self.autopilot.ground_truth.altitude() - HOME[2]

    def away(self, point: Point) -> float:
        """Metres, truly, over ground."""
        _, latitude, longitude, _ = self.autopilot.ground_truth.positions()[-1]
        return point.metres_to(latitude, longitude)

    def nearest(self, point: Point) -> float:
        """Metres at which it ever passed the point, truly, over ground."""
        track = self.autopilot.ground_truth.track()
        return min(point.metres_to(latitude, longitude) for latitude, longitude, _ in track)

    def climbs_to(self, metres: float) -> None:
        self.truly("it has climbed", lambda: self.height() > metres - 1, 60)

    def truly(self, what: str, look: Callable[[], object], seconds: float = FLIGHT_SECONDS) -> None:
        """Waits for what its true state tells."""
        wait_for(what, lambda: look() or None, seconds)

    def comes_to(self, point: Point, metres: float, seconds: float = FLIGHT_SECONDS) -> None:
        self.truly(f"it is at {point}", lambda: self.away(point) <= metres, seconds)

    def is_down(self) -> None:
        """On the ground with its motors off, by its own word and truly."""
        self.truly("its motors are off", lambda: not self.autopilot.ground_truth.armed())
        assert abs(self.height()) < 2, f"{self.height():.1f} m above where it started"

    def upload(self, items: list[Json]) -> None:
        self.do(type="uploadMission", items=items)

    def reached(self) -> list[int]:
        """Numbers of the mission's items, in the order in which they were reached."""
        numbers: list[int] = self.state()["mission"]["reached"]
        return numbers


class Column(NamedTuple):
    """Of the table: a kind of vehicle, and the system id of the one that is flown."""

    name: str
    firmware: Firmware
    system_id: int


@contextlib.contextmanager
def sitl_drones(folder: Path, columns: list[Column], apart_metres: float = 0) -> Iterator[list[SitlDrone]]:
    """A server of its own and autopilots from power-up on, side by side, each listed with its firmware."""
    server = Server(folder / "data")
    server.start()
    autopilots: list[Autopilot] = []
    try:
        for number, (_, firmware, system_id) in enumerate(columns):
            at = place(0, number * apart_metres)
            home = f"{at.latitude:.7f},{at.longitude:.7f},{HOME[2]},0"
            own = folder / f"vehicle-{system_id}"
            autopilots.append(Autopilot(firmware, own, server.udp_port, system_id, home))
        api = Api(server.address, server.local_key())
        yield [_listed(server, api, one, column) for one, column in zip(autopilots, columns, strict=True)]
    finally:
        for autopilot in autopilots:
            autopilot.close()
        server.stop()


def _listed(server: Server, api: Api, autopilot: Autopilot, column: Column) -> SitlDrone:
    def look() -> Json | None:
        return next(
            (d for d in api.drones() if d["link"]["systemId"] == column.system_id and d["firmware"]), None
        )

    drone = wait_for("it is listed with its firmware", look, 60)
    proofs = Proofs(column.name, f"{column.firmware.vehicle} {drone['firmware']}")
    return SitlDrone(server, api, autopilot, drone["id"], proofs)


@contextlib.contextmanager
def sitl_drone(folder: Path, column: Column) -> Iterator[SitlDrone]:
    """One alone; what was proved of its kind before counts for nothing."""
    with sitl_drones(folder, [column]) as (drone,):
        drone.proofs.begin()
        yield drone


def place(north: float, east: float, altitude: float = 0.0) -> Point:
    """Metres from where the autopilots start, and metres above it."""
    latitude = HOME[0] + north / 111_195
    return Point(latitude, HOME[1] + east / (111_195 * 0.67694), altitude)


def waypoint(point: Point, **more: Any) -> Json:
    return {"type": "waypoint", **_where(point), **more}


def look_at(point: Point) -> Json:
    return {"type": "lookAt", **_where(point), "altitude": 0}


def land_at(point: Point) -> Json:
    return {"type": "land", "latitude": point.latitude, "longitude": point.longitude}


def go_to(point: Point) -> Json:
    return {"type": "goTo", **_where(point)}


def _where(point: Point) -> Json:
    return {"latitude": point.latitude, "longitude": point.longitude, "altitude": point.altitude}


def _home() -> Json:
    return {"latitude": HOME[0], "longitude": HOME[1]}
