"""Heartbeats that stay away for a while, as recorded ones do, while all other messages flow."""

import random
import time

GAP_SECONDS = 6.0
LEAST_APART_SECONDS = 12.0
MOST_APART_SECONDS = 25.0
MAVLINK_1, MAVLINK_2 = 0xFE, 0xFD
HEARTBEAT = 0


class HeartbeatGaps:
    """For an impairer to withhold; each vehicle has gaps of its own, by a seed."""

    def __init__(self, seed: int) -> None:
        self._random = random.Random(seed)
        self._begins: dict[int, float] = {}
        self.gaps: dict[int, list[float]] = {}
        """When each began that is over, monotonic seconds, by system id."""

    def drops(self, datagram: bytes) -> bool:
        system_id = _of_heartbeat(datagram)
        if system_id is None:
            return False
        now = time.monotonic()
        begins = self._begins.setdefault(system_id, self._next(now))
        if now >= begins + GAP_SECONDS:
            self.gaps.setdefault(system_id, []).append(begins)
            self._begins[system_id] = self._next(now)
            return False
        return now >= begins

    def _next(self, now: float) -> float:
        return now + self._random.uniform(LEAST_APART_SECONDS, MOST_APART_SECONDS)


def _of_heartbeat(datagram: bytes) -> int | None:
    """Whose heartbeat it is; None: it is something else."""
    if len(datagram) > 9 and datagram[0] == MAVLINK_2:
        return datagram[5] if int.from_bytes(datagram[7:10], "little") == HEARTBEAT else None
    if len(datagram) > 5 and datagram[0] == MAVLINK_1:
        return datagram[3] if datagram[5] == HEARTBEAT else None
    return None
