"""A robot read from its topics, the newest message of each, in either version of ROS."""

from typing import Any, Dict, Optional

from .frames import Localiser
from .messages import battery_of, map_of, map_pose_of, map_shift_of, pose_of, scan_of
from .robot import Battery, Map, Pose, Robot, Scan

SCAN, IMAGE, MAP = "scan", "camera/image/compressed", "map"


class TopicRobot(Robot):
    """Messages come on threads of ROS; each replaces one whole value, so nothing here needs a lock."""

    ODOMETRY, BATTERY = "odom", "battery_state"

    def __init__(self) -> None:
        self._newest: Dict[str, Any] = {}
        self._odometry_frame = "odom"
        self._localiser = Localiser()

    def _seconds_of(self, message: Any) -> float:
        """Time of the message, by the clock of ROS."""
        raise NotImplementedError

    def _newest_callback(self, topic: str) -> Any:
        def store(message: Any) -> None:
            self._newest[topic] = message

        return store

    def _on_odometry(self, message: Any) -> None:
        self._odometry_frame = message.header.frame_id or self._odometry_frame
        self._localiser.odometry(pose_of(message), self._seconds_of(message))

    def _on_pose(self, message: Any) -> None:
        self._localiser.map_pose(map_pose_of(message), self._seconds_of(message))

    def _on_transform(self, message: Any) -> None:
        shift = map_shift_of(message, self._odometry_frame)
        if shift is not None:
            self._localiser.transform(shift)

    def pose(self) -> Optional[Pose]:
        return self._localiser.pose()

    def scan(self) -> Optional[Scan]:
        return scan_of(self._newest.get(SCAN))

    def image(self) -> Optional[bytes]:
        image = self._newest.get(IMAGE)
        return None if image is None else bytes(image.data)

    def map(self) -> Optional[Map]:
        return map_of(self._newest.get(MAP))

    def battery(self) -> Optional[Battery]:
        return battery_of(self._newest.get(self.BATTERY))

    def _goal_pose(self, goal: Any, x: float, y: float) -> Any:
        """A PoseStamped at a place of its map; while it knows none, of its odometry."""
        mapped = self._localiser.localised or MAP in self._newest
        goal.header.frame_id = "map" if mapped else self._odometry_frame
        goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w = float(x), float(y), 1.0
        return goal
