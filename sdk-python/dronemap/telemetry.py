"""Recorded telemetry as a table."""

from typing import Any

from dronemap.contract.models import Points, PointView


class TelemetryTable(dict[str, list[Any]]):
    """Columns by name, all of the same length: `at` (UTC), latitude, longitude, altitude_above_home, …

    Degrees, metres, m/s; None where nobody knows. `pandas.DataFrame(table)` takes it as it is; `points` are the rows.
    """

    def __init__(self, points: Points) -> None:
        names = ["at", *(name for name in PointView.model_fields if name != "at")]
        super().__init__((name, [getattr(point, name) for point in points.points]) for name in names)
        self.drone = points.drone
        self.points = points.points
