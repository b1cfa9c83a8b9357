"""A robot without ROS."""

from typing import List, Optional, Tuple

from roslink_bridge.robot import Map, Pose, Robot, Scan, Speeds


class StandIn(Robot):
    def __init__(self) -> None:
        self.newest_pose: Optional[Pose] = None
        self.newest_scan: Optional[Scan] = None
        self.newest_image: Optional[bytes] = None
        self.newest_map: Optional[Map] = None
        self.per_cent: Optional[float] = None
        self.driven: List[Speeds] = []
        self.goals: List[Optional[Tuple[float, float]]] = []

    def pose(self) -> Optional[Pose]:
        return self.newest_pose

    def scan(self) -> Optional[Scan]:
        return self.newest_scan

    def image(self) -> Optional[bytes]:
        return self.newest_image

    def map(self) -> Optional[Map]:
        return self.newest_map

    def battery(self) -> Optional[float]:
        return self.per_cent

    def drive(self, speeds: Speeds) -> None:
        self.driven.append(speeds)

    def go_to(self, x: float, y: float) -> None:
        self.goals.append((x, y))

    def cancel(self) -> None:
        self.goals.append(None)
