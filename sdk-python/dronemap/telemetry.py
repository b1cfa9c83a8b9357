"""Recorded telemetry as a table."""

from collections.abc import Iterator, Mapping
from typing import Any

from dronemap.contract.models import Points, PointView


class TelemetryTable(Mapping[str, list[Any]]):
    """Columns by name, all of the same length: `at` (UTC), latitude, longitude, altitude_above_home, …

    Degrees, metres, m/s; None where nobody knows. `pandas.DataFrame(table)` takes it as it is.
    """

    def __init__(self, points: Points) -> None:
        self.drone = points.drone
        self.points = points.points
        names = ["at", *(name for name in PointView.model_fields if name != "at")]
        self._columns = {name: [getattr(point, name) for point in points.points] for name in names}

    def __getitem__(self, column: str) -> list[Any]:
        return self._columns[column]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        """How many columns there are; `points` are the rows."""
        return len(self._columns)
