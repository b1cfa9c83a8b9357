"""The bridge itself, without I/O: the newest of the robot in, messages out, orders in."""

import base64
import json
import math
from dataclasses import dataclass
from typing import Any, Callable, ClassVar, Dict, List, NamedTuple, Optional, Tuple

from .picture import png
from .robot import Battery, Robot, Speeds

Message = Dict[str, Any]

HEARTBEAT, STATUS, MOTION, SATELLITES, SCAN, IMAGE, MAP = 0, 1, 2, 3, 4, 5, 6
TWIST, GO_TO, GET_MAP, STOP = 100, 101, 107, 108
SECONDS = {HEARTBEAT: 1.0, STATUS: 1.0, MOTION: 0.2, SATELLITES: 1.0, SCAN: 0.5, IMAGE: 1.0}
#: Speeds count no longer than this: then the robot stands, whatever has become of the cloud or the network.
TWIST_SECONDS = 0.5


class OutgoingMessage(NamedTuple):
    """A message on its way out, and of what kind it is."""

    kind: int
    text: str


@dataclass(frozen=True)
class Identity:
    """Identity and limits of a robot; ``key`` as the cloud issued it."""

    system_id: int
    key: str
    owner: str = ""
    kind: int = 8
    name: str = "robot"
    max_speed: float = 0.5
    max_turn_rate: float = 1.5
    max_height: float = 30.0


class Bridge:
    """Call :meth:`step` at 20 Hz or faster and :meth:`receive` for each text; both answer what to send."""

    #: Numbers that an order cannot do without.
    NEEDED: ClassVar[Dict[int, Tuple[str, ...]]] = {TWIST: ("vx", "vy", "vz", "wz"), GO_TO: ("x", "y")}

    def __init__(self, identity: Identity, robot: Robot) -> None:
        self._identity = identity
        self._robot = robot
        self._makers = self._kinds()
        self._due = dict.fromkeys(SECONDS, -math.inf)
        self._sequence = 0
        self._twist_until: Optional[float] = None
        #: What came and was not for this robot, or no order.
        self.refused = 0

    def step(self, now: float) -> List[OutgoingMessage]:
        """Stops the robot when its speeds have run out; returns the messages that are due."""
        if self._twist_until is not None and now >= self._twist_until:
            self._stop_moving()
        messages = []
        for kind, seconds in SECONDS.items():
            if now >= self._due[kind]:
                body = self._body(kind)
                if body is not None:
                    self._due[kind] = now + seconds
                    messages.append(self._message(kind, body))
        return messages

    def receive(self, text: str, now: float) -> List[OutgoingMessage]:
        order = self._order(text)
        if order is None:
            self.refused += 1
            return []
        return self._execute(order["header"]["message_id"], order, now)

    def _execute(self, kind: int, order: Message, now: float) -> List[OutgoingMessage]:
        if kind == TWIST:
            self._drive(order, now)
        elif kind == GO_TO:
            self._stop_moving()
            self._robot.go_to(number(order, "x"), number(order, "y"))
        elif kind == STOP:
            self._robot.cancel()
            self._stop_moving()
        elif kind == GET_MAP:
            body = self._body(MAP)
            return [] if body is None else [self._message(MAP, body)]
        return []

    def stop(self) -> None:
        """The bridge ends: so does the way that the cloud has sent the robot."""
        self._robot.cancel()
        self._stop_moving()

    def _order(self, text: str) -> Optional[Message]:
        try:
            order = json.loads(text)
            header = order["header"]
            mine = (
                header["system_id"] == self._identity.system_id and str(header["key"]) == self._identity.key
            )
            kind = header["message_id"]
            whole = all(math.isfinite(float(order[name])) for name in self.NEEDED.get(kind, ()))
        except (ValueError, TypeError, KeyError, OverflowError, RecursionError):
            return None
        return order if mine and whole and isinstance(kind, int) else None

    def _drive(self, order: Message, now: float) -> None:
        most, most_turn = self._identity.max_speed, self._identity.max_turn_rate
        speeds = Speeds(
            _bounded(number(order, "vx"), most),
            _bounded(number(order, "vy"), most),
            _bounded(number(order, "vz"), most),
            _bounded(number(order, "wz"), most_turn),
        )
        if speeds == Speeds():
            self._stop_moving()
        else:
            self._twist_until = now + TWIST_SECONDS
            self._robot.drive(speeds)

    def _stop_moving(self) -> None:
        self._twist_until = None
        self._robot.drive(Speeds())

    def _kinds(self) -> Dict[int, Callable[[], Optional[Message]]]:
        return {
            HEARTBEAT: self._heartbeat,
            STATUS: self._status,
            MOTION: self._motion,
            SCAN: self._scan,
            IMAGE: self._image,
            MAP: self._map,
        }

    def _body(self, kind: int) -> Optional[Message]:
        make = self._makers.get(kind)
        return None if make is None else make()

    def _heartbeat(self) -> Message:
        return {"type": self._identity.kind, "name": self._identity.name, "system_status": 2, "mode": 0}

    def _status(self) -> Optional[Message]:
        battery = self._robot.battery()
        return None if battery is None else known(self._charge(battery))

    @staticmethod
    def _charge(battery: Battery) -> Dict[str, Optional[float]]:
        return {
            "voltage_battery": battery.volts,
            "current_battery": battery.amperes,
            "battery_remaining": None if battery.per_cent is None else round(battery.per_cent),
        }

    def _motion(self) -> Optional[Message]:
        pose = self._robot.pose()
        if pose is None:
            return None
        # On wheels z is a yaw, as bridges have it.
        z = pose.yaw if pose.height is None else pose.height
        place = {"x": pose.x, "y": pose.y, "z": z, "heading": pose.yaw}
        return {
            **place,
            "vx": pose.forward,
            "vy": pose.left,
            "vz": pose.up,
            "wx": 0.0,
            "wy": 0.0,
            "wz": pose.turn,
        }

    def _scan(self) -> Optional[Message]:
        scan = self._robot.scan()
        if scan is None:
            return None
        return {
            "angle_min": scan.first_angle,
            "angle_increment": scan.step,
            "range_min": scan.least,
            "range_max": scan.most,
            # JSON knows no infinity: what met nothing is null.
            "ranges": [round(each, 3) if math.isfinite(each) else None for each in scan.ranges],
        }

    def _image(self) -> Optional[Message]:
        image = self._robot.image()
        return None if image is None else {"data": base64.b64encode(image).decode("ascii")}

    def _map(self) -> Optional[Message]:
        area = self._robot.map()
        if area is None:
            return None
        return {
            "data": base64.b64encode(png(area)).decode("ascii"),
            "width": area.columns,
            "height": area.rows,
            "xoffset": area.left,
            "yoffset": area.bottom,
            "resolution": area.resolution,
        }

    def _message(self, kind: int, body: Message) -> OutgoingMessage:
        self._sequence += 1
        header: Message = {
            "roslink_version": 1,
            "ros_version": 8,
            "system_id": self._identity.system_id,
            "message_id": kind,
            "sequence_number": self._sequence,
            "key": self._identity.key,
        }
        if self._identity.owner:
            header["owner_id"] = self._identity.owner
        return OutgoingMessage(kind, json.dumps({"header": header, **body}, allow_nan=False))


def known(body: Dict[str, Optional[float]]) -> Message:
    """The body without members that are not known."""
    return {name: value for name, value in body.items() if value is not None}


def number(order: Message, name: str) -> float:
    return float(order[name])


def _bounded(value: float, most: float) -> float:
    return max(-most, min(most, value))
