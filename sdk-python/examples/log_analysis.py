"""Looks at the recorded flights of a drone. Writes flights.csv, a line a flight, and flights.md, a report for people.

What is recorded comes from the server, so the drone need not be there.
"""

import csv
import statistics
from pathlib import Path

from dronemap import Dronemap, models


def figures(server: Dronemap, flight: models.FlightView) -> dict[str, object]:
    points = server.rest.list_flight_telemetry_points(flight.id, most="20000").points
    heights = [p.altitude_above_home for p in points if p.altitude_above_home is not None]
    speeds = [p.ground_speed for p in points if p.ground_speed is not None]
    charges = [p.battery_percent for p in points if p.battery_percent is not None]
    lost = sum(p.link != "live" for p in points)
    return {
        "drone": flight.drone_name,
        "began": flight.start.isoformat(timespec="seconds"),
        "points": len(points),
        "highest_m": round(max(heights, default=0.0), 1),
        "mean_speed_m_s": round(statistics.fmean(speeds), 2) if speeds else 0.0,
        "fastest_m_s": round(max(speeds, default=0.0), 2),
        "charge_used_percent": charges[0] - charges[-1] if charges else None,
        "points_without_link": lost,
    }


with Dronemap.connect() as server:
    found = [figures(server, flight) for flight in server.rest.list_flights().flights]

if not found:
    raise SystemExit("No flight is recorded yet: fly one, for example with simple_goto.py.")
with Path("flights.csv").open("w", newline="") as file:
    rows = csv.DictWriter(file, found[0])
    rows.writeheader()
    rows.writerows(found)
lines = ["# Flights", "", "| drone | began | highest | fastest | link lost |", "| --- | --- | --- | --- | --- |"]
for flight in found:
    share = f"{flight['points_without_link']} of {flight['points']}"
    lines.append(
        f"| {flight['drone']} | {flight['began']} | {flight['highest_m']} m | {flight['fastest_m_s']} m/s | {share} |"
    )
Path("flights.md").write_text("\n".join(lines) + "\n")
print(f"{len(found)} flights: see flights.csv and flights.md.")
