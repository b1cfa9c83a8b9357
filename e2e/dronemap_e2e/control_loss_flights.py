"""Clients that fly drones, each in a thread of its own, until they lose them."""

import math
import threading
import time
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import UTC, datetime

import requests

from .api import Api, Json
from .control_loss_cases import OPERATIONS, LossCase
from .flight import items
from .ground_station import User
from .runs import create_plan
from .server import Server
from .steering_client import SteeringClient
from .waiting import wait_for
from .walker import beside

EVERY = 1.0
AWAY_METRES = 60.0
SPEED = 2.0
STICK = 0.4
# There and back again, at what these vehicles fly.
LEGS = 8
LEG_METRES = 90.0
PATIENCE = 10
GUIDED_MODES = {"sticks": "LOITER"}


@dataclass
class FlightClient:
    """One drone, and the client that flies it."""

    case: LossCase
    system_id: int
    drone: Json
    server: Server
    user: User
    # None: by the session.
    key: str | None
    admin: Api
    absent_user: str = ""
    gone: threading.Event = field(default_factory=threading.Event)
    thread: threading.Thread | None = None
    steering: SteeringClient | None = None
    epoch: int = 0
    follow: str = ""
    run: str = ""
    plan: str = ""
    virtual: str = ""
    flies_to_and_fro: bool = False
    send_count: int = 0

    def __post_init__(self) -> None:
        self.api = Api(self.server.address, self.key) if self.key else self.user.api

    @property
    def id(self) -> str:
        return str(self.drone["id"])

    @property
    def operates(self) -> bool:
        """An operation has it, which stands aside for others."""
        return self.case.kind in OPERATIONS

    @property
    def height(self) -> float:
        """A height of its own, so that few give way to others."""
        return 15.0 + 4 * ((self.case.number - 1) % 6)

    @property
    def direction(self) -> float:
        return math.radians(60.0 * ((self.case.number - 1) % 6))

    def there(self, metres: float) -> Json:
        east, north = metres * math.sin(self.direction), metres * math.cos(self.direction)
        point = beside(self.drone["home"], east, north)
        return {"latitude": point.latitude, "longitude": point.longitude}

    def prepare(self) -> None:
        """All that may take its time; it stands on the ground."""
        kind = self.case.kind
        if kind == "mission":
            self.api.do(self.id, type="uploadMission", items=self._items())
        elif kind == "run":
            self.plan = create_plan(self.api, [self.drone], self._waypoints())
        elif kind == "virtual":
            body = {"name": f"moment {self.case.number}", "items": self._items()}
            self.virtual = self._create("/virtual-drones", body)
            assert self.admin.call("PUT", f"/warehouse/{self.id}", {}).ok
        elif kind == "follow":
            place = {"side": "fixed", "bearing": 180, "distance": 5, "height": self.height}
            order = self.there(40) | {"drone": self.id, "place": place, "patience": PATIENCE}
            self.follow = self._create("/follows", order)

    def start(self) -> None:
        """Into the air; goes on by itself then."""
        kind = self.case.kind
        if kind in OPERATIONS:
            self._start_operation()
        else:
            if self.case.explicit:
                self.epoch = int(self._take_control()["epoch"])
            self.thread = threading.Thread(target=self._send_loop, daemon=True)
            self.thread.start()
            self._take_off()

    def _start_operation(self) -> None:
        if self.case.kind == "run":
            asked = {"plan": self.plan, "onCloudLoss": "continue", "searchSeconds": 0}
            self.run = self._create("/runs", asked)
        elif self.case.kind == "virtual":
            answer = self.api.call("POST", f"/virtual-drones/{self.virtual}/start")
            assert answer.status_code == 202, answer.text
        else:
            self._send_position()
            answer = self.api.call("POST", f"/follows/{self.follow}/start")
            assert answer.ok, answer.text
        self.thread = threading.Thread(target=self._send_loop, daemon=True)
        self.thread.start()

    def _take_off(self) -> None:
        # Its own connection: that of the session belongs to the thread that talks.
        api = Api(self.server.address, self.key) if self.key else self.user.api
        if self.case.kind == "mission":
            api.do(self.id, type="arm")
            api.do(self.id, type="startMission")
            return
        api.do(self.id, type="setMode", mode="GUIDED")
        api.do(self.id, type="arm")
        api.do(self.id, type="takeOff", altitude=self.height)
        wait_for(f"{self.case} is up", lambda: self._above(self.height - 1), 60)
        if self.case.kind in GUIDED_MODES:
            api.do(self.id, type="setMode", mode=GUIDED_MODES[self.case.kind])
        if self.case.kind in ("velocity", "sticks"):
            self.steering = self._steer(api)
        self.flies_to_and_fro = True

    def _steer(self, api: Api) -> SteeringClient:
        by = self.case.kind
        ticket = ""
        if not self.key:
            answer = api.call("POST", "/stream-tickets")
            assert answer.ok, answer.text
            ticket = answer.json()["ticket"]
        forward = SPEED if by == "velocity" else STICK
        return SteeringClient(self.server, self.key, self.id, forward, by, ticket)

    def is_flying(self) -> bool:
        """In the air, and in the mode of its kind, or standing there while it gives way to another one."""
        now = self.admin.drone(self.id)
        if not self._above(4) or not now["armed"]:
            return False
        mode = {"mission": "AUTO", "run": "AUTO", "virtual": "AUTO", "sticks": "LOITER"}
        return now["mode"] in (mode.get(self.case.kind, "GUIDED"), "GUIDED" if self.operates else "")

    def _above(self, metres: float) -> bool:
        position = self.admin.drone(self.id)["position"]
        return bool(position and position["altitudeAboveHome"] > metres)

    def disconnect(self) -> None:
        """Silently: nothing is closed that an end of the program would not close."""
        self.gone.set()
        if self.thread is not None:
            self.thread.join(10)
        if self.steering is not None:
            self.steering.kill()

    def stop_sending(self) -> None:
        """Sends nothing more; its connections stay open."""
        self.gone.set()
        if self.thread is not None:
            self.thread.join(10)
        if self.steering is not None:
            self.steering.cut()

    def go_to(self, metres: float) -> Json:
        target = self.there(metres)
        answer = self.api.call(
            "POST", f"/drones/{self.id}/commands", {"type": "goTo", **target, "altitude": self.height}
        )
        assert answer.ok, answer.text
        return target

    def _take_control(self) -> Json:
        answer = self.api.call("POST", f"/drones/{self.id}/control/take")
        assert answer.ok, answer.text
        taken: Json = answer.json()
        return taken

    def _send_loop(self) -> None:
        """Sends signs and commands once a second, whether or not they are refused."""
        api = Api(self.server.address, self.key) if self.key else self.user.api
        while not self.gone.wait(EVERY):
            with suppress(requests.RequestException):
                self._send_once(api)

    def _send_once(self, api: Api) -> None:
        self.send_count += 1
        if self.epoch:
            api.call("POST", f"/drones/{self.id}/control/heartbeat", {"epoch": self.epoch})
        if self.follow:
            self._send_position()
        elif self.case.kind == "guided" and self.flies_to_and_fro:
            target = self.there(AWAY_METRES + 20 * (self.send_count % 2))
            api.call(
                "POST", f"/drones/{self.id}/commands", {"type": "goTo", **target, "altitude": self.height}
            )

    def _send_position(self) -> None:
        at = datetime.fromtimestamp(time.time(), UTC).isoformat()
        here = {"at": at, "accuracy": 4, **self.there(40)}
        self.api.call("POST", f"/follows/{self.follow}/positions", {"sent": at, "positions": [here]})

    def _create(self, path: str, body: Json) -> str:
        answer = self.api.call("POST", path, body)
        assert answer.status_code == 201, answer.text
        made: str = answer.json()["id"]
        return made

    def _items(self) -> list[Json]:
        points = [
            beside(self.drone["home"], east, north)
            for east, north in (
                (metres * math.sin(self.direction), metres * math.cos(self.direction))
                for metres in self._metres()
            )
        ]
        return [{**one, "altitude": self.height} for one in items(points)]

    def _waypoints(self) -> list[Json]:
        above = self.drone["home"]["altitudeAmsl"] + self.height
        # In a row: a plan would not fly there and back.
        return [
            {**self.there(LEG_METRES / 2 * (n + 1)), "altitude": above, "altitudeReference": "amsl"}
            for n in range(LEGS)
        ]

    def _metres(self) -> list[float]:
        return [LEG_METRES if n % 2 == 0 else 10.0 for n in range(LEGS)]
