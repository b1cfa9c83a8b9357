"""Locates a robot on its map from odometry, which drifts, and a localiser's occasional corrections."""

import math
import threading
from collections import deque
from dataclasses import dataclass, replace
from typing import Deque, Optional, Tuple

from .robot import Pose

#: Of 20 to 50 a second; what localises a robot says what was so less than two seconds ago.
KEPT = 100


@dataclass(frozen=True)
class Pose2D:
    """A place and a turn: of a robot in a frame, or of a frame in another."""

    x: float
    y: float
    yaw: float

    def of(self, inner: "Pose2D") -> "Pose2D":
        """A pose of the inner frame, as seen from the outer one."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        return Pose2D(
            self.x + cos * inner.x - sin * inner.y,
            self.y + sin * inner.x + cos * inner.y,
            math.remainder(self.yaw + inner.yaw, math.tau),
        )

    def inverse(self) -> "Pose2D":
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        return Pose2D(-cos * self.x - sin * self.y, sin * self.x - cos * self.y, -self.yaw)


class Localiser:
    """The newest odometry in the frame of the map, once it is known how that lies. Any thread; seconds."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._history: Deque[Tuple[float, Pose]] = deque(maxlen=KEPT)
        self._shift: Optional[Pose2D] = None
        self._has_transform = False

    def odometry(self, pose: Pose, stamp: float) -> None:
        with self._lock:
            self._history.append((stamp, pose))

    def transform(self, odometry_in_map: Pose2D) -> None:
        """Applies a transform of tf: from now on nothing else is needed."""
        with self._lock:
            self._has_transform = True
            self._shift = odometry_in_map

    def map_pose(self, robot_in_map: Pose2D, stamp: float) -> None:
        """Applies a pose of AMCL, of a moment that has passed; since then the robot has moved on."""
        with self._lock:
            if self._has_transform or not self._history:
                return
            _, then = min(self._history, key=lambda one: abs(one[0] - stamp))
            self._shift = robot_in_map.of(Pose2D(then.x, then.y, then.yaw).inverse())

    @property
    def localised(self) -> bool:
        return self._shift is not None

    def pose(self) -> Optional[Pose]:
        with self._lock:
            if not self._history:
                return None
            _, newest = self._history[-1]
            if self._shift is None:
                return newest
            there = self._shift.of(Pose2D(newest.x, newest.y, newest.yaw))
            return replace(newest, x=there.x, y=there.y, yaw=there.yaw)
