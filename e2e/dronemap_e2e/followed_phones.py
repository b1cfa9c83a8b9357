"""Phones that stand still, each followed by a simulated copter; the follow by each face and on the wire."""

import json
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Any

from websockets.sync.client import connect

from .api import Api, Json
from .flight import ARMED, COPTER_RTL, Point
from .message_recorder import MessageRecorder, RecordedMessage
from .server import Server
from .soap import soap
from .waiting import wait_for
from .walker import beside

DISTANCE = 5
TAKE_OFF = 22
COPTER_LAND = 9
# A drone on its way there needs nobody.
HOMEWARD = (COPTER_RTL, COPTER_LAND)
STREAM_SECONDS = 20


@dataclass
class FollowedPhone:
    """A phone, and the follow that is about it."""

    system_id: int
    drone: Json
    height: float
    patience: int
    follow: str = ""
    sends_positions: bool = True
    # Somebody at the vehicle flies it by sticks.
    piloted: bool = False
    sent_at: float = 0.0
    east: float = 0.0
    north: float = 40.0
    # The stages that it was seen at, each once until the next one.
    stages: list[str] = field(default_factory=list)

    @property
    def phone(self) -> Point:
        return beside(self.drone["home"], self.east, self.north)

    @property
    def place(self) -> Point:
        """The place at which its drone is to be."""
        return beside(self.drone["home"], self.east, self.north - DISTANCE)

    def request_follow(self, api: Api) -> None:
        order = {
            "latitude": self.phone.latitude,
            "longitude": self.phone.longitude,
            "drone": self.drone["id"],
            "place": {"side": "fixed", "bearing": 180, "distance": DISTANCE, "height": self.height},
            "patience": self.patience,
        }
        answer = api.call("POST", "/follows", order)
        assert answer.status_code == 201, answer.text
        self.follow = answer.json()["id"]

    def request(self, api: Api, what: str) -> None:
        answer = api.call("POST", f"/follows/{self.follow}/{what}")
        assert answer.ok, answer.text

    def send_position(self, api: Api) -> None:
        """Sends its position, once a second, as long as it is followed."""
        now = time.time()
        if not self.sends_positions or now - self.sent_at < 1:
            return
        self.sent_at = now
        at = datetime.fromtimestamp(now, UTC).isoformat()
        here = {"at": at, "latitude": self.phone.latitude, "longitude": self.phone.longitude, "accuracy": 4}
        answer = api.call("POST", f"/follows/{self.follow}/positions", {"sent": at, "positions": [here]})
        assert answer.ok or answer.status_code == 409, answer.text

    def record_stage(self, stage: str) -> None:
        if not self.stages or self.stages[-1] != stage:
            self.stages.append(stage)


class ReportedState:
    """State of vehicles by their own messages, also while no server listens."""

    KINDS = ("GLOBAL_POSITION_INT", "HEARTBEAT", "COMMAND_LONG", "COMMAND_INT")

    def __init__(self, recorder: MessageRecorder) -> None:
        self._recorder = recorder

    def mode(self, one: FollowedPhone) -> int:
        return int(self._last("HEARTBEAT", one).message.custom_mode)

    def armed(self, one: FollowedPhone) -> bool:
        return bool(self._last("HEARTBEAT", one).message.base_mode & ARMED)

    def take_off_commanded(self, one: FollowedPhone) -> bool:
        return any(
            recorded.message.command == TAKE_OFF and recorded.message.target_system == one.system_id
            for recorded in self._recorder.messages("COMMAND_LONG", "COMMAND_INT", up=False)
        )

    def height(self, one: FollowedPhone) -> float:
        return float(self._last("GLOBAL_POSITION_INT", one).message.relative_alt) / 1000

    def metres_to(self, one: FollowedPhone, there: Point) -> float:
        message = self._last("GLOBAL_POSITION_INT", one).message
        return there.metres_to(message.lat / 1e7, message.lon / 1e7)

    def distance_moved(self, one: FollowedPhone, since: float) -> float:
        """Metres from where it was at that moment (monotonic s), at most."""
        track = [h.message for h in self._of("GLOBAL_POSITION_INT", one) if h.at >= since]
        first = Point(track[0].lat / 1e7, track[0].lon / 1e7, 0)
        return max(first.metres_to(message.lat / 1e7, message.lon / 1e7) for message in track)

    def _last(self, kind: str, one: FollowedPhone) -> RecordedMessage:
        return self._of(kind, one)[-1]

    def _of(self, kind: str, one: FollowedPhone) -> list[RecordedMessage]:
        return [
            recorded
            for recorded in self._recorder.messages(kind, up=True)
            if recorded.message.get_srcSystem() == one.system_id and recorded.message.get_srcComponent() == 1
        ]


class FollowGroup:
    """All followed phones; while a test waits, they send their positions."""

    def __init__(self, phones: Iterable[FollowedPhone], reported: ReportedState) -> None:
        self.phones = list(phones)
        self.reported = reported

    def wait_until(self, api: Api, what: str, condition: Callable[[], object], seconds: float) -> None:
        def looked() -> object:
            for one in self.phones:
                one.send_position(api)
            for follow in self.follows_by_id(api).values():
                self.of(follow["id"]).record_stage(follow["state"])
            return condition()

        wait_for(what, looked, seconds, every=0.2)

    def of(self, follow: str) -> FollowedPhone:
        return next(one for one in self.phones if one.follow == follow)

    def follows_by_id(self, api: Api) -> dict[str, Json]:
        """The group's follows in REST, by id."""
        mine = {one.follow for one in self.phones}
        return {one["id"]: one for one in api.get("/follows")["follows"] if one["id"] in mine}

    def unattended(self, api: Api) -> list[str]:
        """Drones that nobody has, and that neither go home nor stand on the ground nor are waited for."""
        follows = self.follows_by_id(api)
        drones = {drone["id"]: drone for drone in api.drones()}
        return [
            f"{one.system_id}: {follows[one.follow]['state']}, {drones[one.drone['id']]['control']}"
            for one in self.phones
            if drones[one.drone["id"]]["control"]["state"] == "free"
            and not one.piloted
            and self.reported.armed(one)
            and self.reported.mode(one) not in HOMEWARD
            and not (follows[one.follow]["note"] or "").startswith("Nobody has")
        ]


def stages_by_soap(server: Server, key: str, follows: Iterable[str]) -> dict[str, str]:
    """Each one's stage."""
    service = soap(server, key, "FollowerService")
    return {follow: service.getFollow(followId=follow).state for follow in follows}


def stages_by_stream(server: Server, key: str, follows: Iterable[str]) -> dict[str, str]:
    """Each one's stage, as the stream sends it after a connect."""
    wanted = set(follows)
    found: dict[str, str] = {}
    with connect(server.stream_address, additional_headers={"Authorization": f"Bearer {key}"}) as stream:
        deadline = time.monotonic() + STREAM_SECONDS
        while set(found) != wanted:
            assert time.monotonic() < deadline, f"the stream does not tell of {wanted - set(found)}"
            message: Any = json.loads(stream.recv(timeout=STREAM_SECONDS))
            if message["type"] == "follow" and message["follow"]["id"] in wanted:
                found[message["follow"]["id"]] = message["follow"]["state"]
    return found
