"""A PX4 copter of our own, spoken with pymavlink: it takes PX4's ways only, and flies like a point mass."""

import math
import threading
import time
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from .peer import ACCEPTED, Kind, Peer

DENIED = mavlink.MAV_RESULT_DENIED
UNSUPPORTED = mavlink.MAV_RESULT_UNSUPPORTED
METRES_PER_DEGREE = 111_195.0
HOME = (47.3977, 8.5456)
HOME_ALTITUDE = 488.0
SPEED, CLIMB, STEP = 40.0, 12.0, 0.1
AUTO = 4
TAKE_OFF, LOITER, MISSION, RTL, LAND = 2, 3, 4, 5, 6


class Px4Peer:
    """Modes are (main << 16 | sub << 24); whatever PX4 does not know is refused."""

    def __init__(self, port: int, system_id: int) -> None:
        self.latitude, self.longitude, self.height = HOME[0], HOME[1], 0.0
        self.goal: tuple[float, float, float] | None = None
        self.items: list[Any] = []
        self.incoming: dict[int, Any] = {}
        self.expected = 0
        self.current = 0
        self.refused: list[int] = []
        self.peer = Peer(
            port,
            system_id,
            Kind(mavlink.MAV_TYPE_QUADROTOR, mavlink.MAV_AUTOPILOT_PX4),
            {
                "COMMAND_LONG": self._command,
                "COMMAND_INT": self._command,
                "MISSION_COUNT": self._count,
                "MISSION_ITEM_INT": self._item,
                "MISSION_REQUEST_LIST": self._list,
                "MISSION_REQUEST_INT": self._send_item,
                "MISSION_REQUEST": self._send_item,
            },
        )
        self._mode(LOITER)
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._fly, daemon=True)
        self._thread.start()

    def close(self) -> None:
        self._closing.set()
        self._thread.join()
        self.peer.close()

    @property
    def sub_mode(self) -> int:
        return self.peer.state.custom_mode >> 24

    def _mode(self, sub: int) -> None:
        self.peer.state.custom_mode = (AUTO << 16) | (sub << 24)

    def _command(self, peer: Peer, message: Any) -> None:
        result = self._apply_command(peer, message)
        if result != ACCEPTED:
            self.refused.append(message.command)
        peer.acknowledge(message, result)
        peer.beat()

    def _apply_command(self, peer: Peer, message: Any) -> int:
        command = message.command
        if command == mavlink.MAV_CMD_COMPONENT_ARM_DISARM:
            peer.state.armed = message.param1 == 1
            return int(ACCEPTED)
        if command == mavlink.MAV_CMD_NAV_TAKEOFF:
            return self._take_off(message)
        if command == mavlink.MAV_CMD_DO_REPOSITION:
            return self._reposition(message)
        if command == mavlink.MAV_CMD_DO_SET_MODE:
            return self._set_mode(int(message.param2), int(message.param3))
        if command == mavlink.MAV_CMD_REQUEST_MESSAGE:
            return int(self._send_requested(int(message.param1)))
        if command == mavlink.MAV_CMD_SET_MESSAGE_INTERVAL:
            return int(ACCEPTED)
        return int(UNSUPPORTED)

    def _take_off(self, message: Any) -> int:
        altitude = message.param7 if message.get_type() == "COMMAND_LONG" else message.z
        if not self.peer.state.armed or altitude < HOME_ALTITUDE + 1:
            return int(DENIED)
        self.goal = (self.latitude, self.longitude, altitude - HOME_ALTITUDE)
        self._mode(TAKE_OFF)
        return int(ACCEPTED)

    def _reposition(self, message: Any) -> int:
        if message.get_type() != "COMMAND_INT" or not self.peer.state.armed:
            return int(DENIED)
        relative = message.frame in (3, 6)
        self.goal = (message.x / 1e7, message.y / 1e7, message.z if relative else message.z - HOME_ALTITUDE)
        self._mode(LOITER)
        return int(ACCEPTED)

    def _set_mode(self, main: int, sub: int) -> int:
        if main != AUTO or (sub == MISSION and not self.items):
            return int(DENIED)
        self._mode(sub)
        if sub == LOITER:
            self.goal = (self.latitude, self.longitude, self.height)
        return int(ACCEPTED)

    def _send_requested(self, message_id: int) -> int:
        if message_id == mavlink.MAVLINK_MSG_ID_HOME_POSITION:
            self._home()
            return int(ACCEPTED)
        return int(UNSUPPORTED)

    def _count(self, peer: Peer, message: Any) -> None:
        self.incoming, self.expected = {}, message.count
        if message.count == 0:
            self.items = []
            peer.link.mission_ack_send(message.get_srcSystem(), message.get_srcComponent(), 0)
        else:
            peer.link.mission_request_int_send(message.get_srcSystem(), message.get_srcComponent(), 0)

    def _item(self, peer: Peer, message: Any) -> None:
        """PX4 keeps its old mission until the new one is whole."""
        self.incoming[message.seq] = message
        if len(self.incoming) < self.expected:
            peer.link.mission_request_int_send(
                message.get_srcSystem(), message.get_srcComponent(), len(self.incoming)
            )
            return
        self.items = [self.incoming[i] for i in range(self.expected)]
        self.current = 0
        peer.link.mission_ack_send(message.get_srcSystem(), message.get_srcComponent(), 0)

    def _list(self, peer: Peer, message: Any) -> None:
        peer.link.mission_count_send(message.get_srcSystem(), message.get_srcComponent(), len(self.items))

    def _send_item(self, peer: Peer, message: Any) -> None:
        if message.seq >= len(self.items):
            return
        item = self.items[message.seq]
        peer.link.mission_item_int_send(
            *(message.get_srcSystem(), message.get_srcComponent(), message.seq, item.frame, item.command),
            *(int(message.seq == self.current), item.autocontinue),
            *(item.param1, item.param2, item.param3, item.param4, item.x, item.y, item.z),
        )

    def _home(self) -> None:
        self.peer.link.home_position_send(
            int(HOME[0] * 1e7), int(HOME[1] * 1e7), int(HOME_ALTITUDE * 1000), 0, 0, 0, [1, 0, 0, 0], 0, 0, 0
        )

    def _fly(self) -> None:
        ticks = 0
        while not self._closing.wait(STEP):
            ticks += 1
            self._steer()
            self._report()
            if ticks % 10 == 0:
                self._home()

    def _steer(self) -> None:
        if self.sub_mode == MISSION and self.peer.state.armed:
            self._next_item()
        elif self.sub_mode == RTL:
            away = self._away(*HOME)
            self.goal = (*HOME, self.height if away > 1 else 0.0)
        elif self.sub_mode == LAND:
            self.goal = (self.latitude, self.longitude, 0.0)
        if self.goal and self.peer.state.armed:
            self._move(self.goal)
        if self.sub_mode in (RTL, LAND) and self.height < 0.1 and self.peer.state.armed:
            self.peer.state.armed = False
            self.peer.beat()

    def _next_item(self) -> None:
        item = self.items[self.current]
        if item.command == mavlink.MAV_CMD_NAV_TAKEOFF:
            above = item.z if item.frame in (3, 6) else item.z - HOME_ALTITUDE
            self.goal = (self.latitude, self.longitude, max(self.height, above))
        else:
            self.goal = (item.x / 1e7, item.y / 1e7, item.z)
        latitude, longitude, height = self.goal
        if self._away(latitude, longitude) < 0.5 and abs(height - self.height) < 0.5:
            self.peer.link.mission_item_reached_send(self.current)
            if self.current + 1 < len(self.items):
                self.current += 1
            else:
                self._mode(LOITER)

    def _away(self, latitude: float, longitude: float) -> float:
        north = (latitude - self.latitude) * METRES_PER_DEGREE
        east = (longitude - self.longitude) * METRES_PER_DEGREE * math.cos(math.radians(self.latitude))
        return math.hypot(north, east)

    def _move(self, goal: tuple[float, float, float]) -> None:
        latitude, longitude, height = goal
        away = self._away(latitude, longitude)
        share = 1.0 if away <= SPEED * STEP else SPEED * STEP / away
        self.latitude += (latitude - self.latitude) * share
        self.longitude += (longitude - self.longitude) * share
        self.height += max(-CLIMB * STEP, min(CLIMB * STEP, height - self.height))

    def _report(self) -> None:
        link, now = self.peer.link, int(time.monotonic() * 1000) & 0xFFFFFFFF
        above = int(self.height * 1000)
        link.global_position_int_send(
            now,
            *(int(self.latitude * 1e7), int(self.longitude * 1e7)),
            *(int(HOME_ALTITUDE * 1000) + above, above, 0, 0, 0, 0),
        )
        landed = mavlink.MAV_LANDED_STATE_IN_AIR if self.height > 0.3 else mavlink.MAV_LANDED_STATE_ON_GROUND
        link.extended_sys_state_send(0, landed)
        if self.items:
            link.mission_current_send(self.current)
