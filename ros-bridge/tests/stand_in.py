"""A robot without ROS."""

from typing import List, Optional, Tuple

from roslink_bridge.robot import Battery, Flight, Flyer, Map, Pose, Robot, Satellites, Scan, Speeds


class StandIn(Robot):
    def __init__(self) -> None:
        self.newest_pose: Optional[Pose] = None
        self.newest_scan: Optional[Scan] = None
        self.newest_image: Optional[bytes] = None
        self.newest_map: Optional[Map] = None
        self.charge: Optional[Battery] = None
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

    def battery(self) -> Optional[Battery]:
        return self.charge

    def drive(self, speeds: Speeds) -> None:
        self.driven.append(speeds)

    def go_to(self, x: float, y: float) -> None:
        self.goals.append((x, y))

    def cancel(self) -> None:
        self.goals.append(None)


class FlyingStandIn(StandIn, Flyer):
    def __init__(self) -> None:
        super().__init__()
        self.newest_flight: Optional[Flight] = None
        self.seen: Optional[Satellites] = None
        self.asked: List[object] = []

    def flight(self) -> Optional[Flight]:
        return self.newest_flight

    def satellites(self) -> Optional[Satellites]:
        return self.seen

    def arm(self, wanted: bool) -> None:
        self.asked.append(("arm", wanted))

    def set_mode(self, number: int) -> None:
        self.asked.append(("mode", number))

    def take_off(self, height: float) -> None:
        self.asked.append(("take off", height))

    def land(self) -> None:
        self.asked.append("land")
