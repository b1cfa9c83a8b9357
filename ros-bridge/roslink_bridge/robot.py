"""What the bridge needs of a robot, whichever version of ROS it runs; metres, radians, seconds."""

from dataclasses import dataclass, field
from typing import List, Optional, Protocol


@dataclass(frozen=True)
class Pose:
    x: float
    y: float
    yaw: float
    forward: float = 0.0
    left: float = 0.0
    turn: float = 0.0


@dataclass(frozen=True)
class Scan:
    first_angle: float
    step: float
    least: float
    most: float
    ranges: List[float] = field(default_factory=list)


@dataclass(frozen=True)
class Map:
    """Rows from the bottom up, as ROS keeps them: -1 unknown, 0 free to 100 occupied."""

    columns: int
    rows: int
    resolution: float
    left: float
    bottom: float
    cells: List[int] = field(default_factory=list)


@dataclass(frozen=True)
class Speeds:
    forward: float = 0.0
    left: float = 0.0
    up: float = 0.0
    turn: float = 0.0


class Robot(Protocol):
    """The newest of everything; None where it has not told yet."""

    def pose(self) -> Optional[Pose]: ...

    def scan(self) -> Optional[Scan]: ...

    def image(self) -> Optional[bytes]:
        """A JPEG or PNG."""

    def map(self) -> Optional[Map]: ...

    def battery(self) -> Optional[float]:
        """Per cent."""

    def drive(self, speeds: Speeds) -> None: ...

    def go_to(self, x: float, y: float) -> None:
        """In the frame of its map."""

    def cancel(self) -> None:
        """Gives up where it is going to."""
