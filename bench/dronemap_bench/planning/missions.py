"""The benchmark instances as missions of several drones, through the server's own plans.

`python3 -m dronemap_bench.planning.missions`: each instance is laid out on the ground, a simulated drone
stands at each depot, and `POST /plans` searches as long as the planner by itself does on the same places.
When the last drone is back, by both, tells what the way through the server costs. Longest tours are measured
in time, as they are flown: a stop takes time of its own, so that plans differ from those that measure way.
"""

import argparse
import contextlib
import json
import math
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path

from ..programs import LOAD_JAR, Json, Server
from .modes import SEVEN
from .problems import Point, Problem, Row, read
from .runs import JAVA

BASE_LATITUDE, BASE_LONGITUDE = 47.4, 8.5
METRES_PER_DEGREE = 6_371_000 * math.pi / 180
LONGEST_TOUR_METRES = 3_000
"""Within the battery that a drone of this kind is taken to have."""

HEIGHT_METRES = 60
GROUND_METRES = 488
READY_SECONDS = 180
WARM_UP_SECONDS = 4


class FieldProjection:
    """Projects an instance to the ground, at a scale at which drones can fly its longest tour."""

    def __init__(self, row: Row) -> None:
        places = (*row.problem.depots, *row.problem.waypoints)
        self._scale = LONGEST_TOUR_METRES / row.best
        self._middle = (
            statistics.fmean(x for x, _ in places),
            statistics.fmean(y for _, y in places),
        )

    def at(self, place: Point) -> tuple[float, float]:
        """Latitude and longitude."""
        east = (place[0] - self._middle[0]) * self._scale
        north = (place[1] - self._middle[1]) * self._scale
        narrowing = math.cos(math.radians(BASE_LATITUDE))
        return (
            BASE_LATITUDE + north / METRES_PER_DEGREE,
            BASE_LONGITUDE + east / METRES_PER_DEGREE / narrowing,
        )

    def text(self, place: Point) -> str:
        latitude, longitude = self.at(place)
        return f"{latitude:.8f} {longitude:.8f}"


@contextlib.contextmanager
def ready_drones(server: Server, ground: FieldProjection, depots: tuple[Point, ...]) -> Iterator[None]:
    """A simulated drone at each depot, numbered from 1."""
    running = []
    try:
        for number, depot in enumerate(depots, 1):
            arguments = [
                *("--connect", f"udp://127.0.0.1:{server.udp_port}", "--sysid", str(number), "--count", "1"),
                *("--home", f"{ground.text(depot).replace(' ', ',')},{GROUND_METRES}"),
            ]
            running.append(
                subprocess.Popen(
                    ["java", "-Xmx64m", "-XX:+UseSerialGC", "-jar", str(LOAD_JAR), *arguments],
                    stdout=subprocess.DEVNULL,
                )
            )
        yield
    finally:
        for process in running:
            process.terminate()
        for process in running:
            process.wait(30)


def drones(server: Server, count: int) -> list[str]:
    """Ids in the order of the depots, once all is known of them that a plan takes."""
    deadline = time.monotonic() + READY_SECONDS
    while time.monotonic() < deadline:
        known = {
            drone["link"]["systemId"]: drone["id"]
            for drone in server.get("/drones")["drones"]
            if drone["link"]["state"] == "live"
            and drone["home"]
            and drone["battery"]
            and drone["link"]["quality"]["lossShort"] is not None
        }
        if len(known) == count:
            return [known[number] for number in sorted(known)]
        time.sleep(0.5)
    raise SystemExit(f"Not all {count} drones got ready")


def request_plan(server: Server, body: Json) -> Json:
    """The finished plan."""
    request = urllib.request.Request(
        f"http://127.0.0.1:{server.http_port}/api/v1/plans",
        data=json.dumps(body).encode(),
        headers={"Authorization": f"Bearer {server.key()}", "Content-Type": "application/json"},
    )
    with urllib.request.urlopen(request, timeout=60) as answer:
        plan: Json = json.loads(answer.read())
    while plan["state"] in ("queued", "running"):
        time.sleep(0.2)
        plan = server.get(f"/plans/{plan['id']}")
    if plan["state"] != "finished":
        raise SystemExit(f"The plan is {plan['state']}: {plan['why']}")
    return plan


def solve_directly(row: Row, ground: FieldProjection, plan: tuple[float, int], folder: Path) -> float:
    """Seconds until the last drone is back, in the plan that the planner finds without the server."""
    places = [("drone", place, GROUND_METRES) for place in row.problem.depots]
    places += [("waypoint", place, GROUND_METRES + HEIGHT_METRES) for place in row.problem.waypoints]
    lines = [f"{what} {ground.text(place)} {height}" for what, place, height in places]
    file = folder / "places"
    file.write_text("\n".join(lines) + "\n")
    seconds, seed = plan
    arguments = [str(file), str(seed), str(seconds), str(WARM_UP_SECONDS)]
    command = [*JAVA[:-1], "org.dronemap.bench.planning.OfflinePlanning", *arguments]
    output = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout
    return float(output.split()[1])


def request(problem: Problem, ground: FieldProjection, ids: list[str], seconds: float, seed: int) -> Json:
    places = [ground.at(waypoint) for waypoint in problem.waypoints]
    return {
        "drones": ids,
        "seconds": seconds,
        "seed": seed,
        "waypoints": [
            {
                "id": str(number),
                "latitude": latitude,
                "longitude": longitude,
                "altitude": GROUND_METRES + HEIGHT_METRES,
                "altitudeReference": "amsl",
            }
            for number, (latitude, longitude) in enumerate(places)
        ],
    }


def measure(server: Server, row: Row, seconds: float, seeds: int) -> tuple[float, float]:
    """Measures when the last drone is back: by the planner alone, and through the server; medians."""
    ground = FieldProjection(row)
    numbers = range(1, seeds + 1)
    with tempfile.TemporaryDirectory() as folder:
        by_itself = [solve_directly(row, ground, (seconds, seed), Path(folder)) for seed in numbers]
    through = []
    with ready_drones(server, ground, row.problem.depots):
        ids = drones(server, len(row.problem.depots))
        # The first search of a server is cold.
        request_plan(server, request(row.problem, ground, ids, WARM_UP_SECONDS, 99))
        for seed in numbers:
            plan = request_plan(server, request(row.problem, ground, ids, seconds, seed))
            if plan["progress"]["unserved"]:
                raise SystemExit(f"{row.name}: {plan['result']['unserved'][0]['why']}")
            through.append(plan["progress"]["longestSeconds"])
    return statistics.median(by_itself), statistics.median(through)


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="missions", description=__doc__)
    parser.add_argument("--data", type=Path, required=True, help="folder with index.csv")
    parser.add_argument("--instance", action="append", help="this one instead of the seven; may be repeated")
    parser.add_argument("--seconds", type=float, default=5, help="of search, CPU and wall clock (default: 5)")
    parser.add_argument("--seeds", type=int, default=3)
    options = parser.parse_args(arguments)
    wanted = options.instance or SEVEN
    rows = [row for row in read(options.data) if row.name in wanted and row.problem.aim == "longest"]
    print("| instance | alone, s | through the server, s | lost, % |\n|---|---|---|---|")
    lost = []
    for row in rows:
        # A server each: drones of another instance are strangers.
        with tempfile.TemporaryDirectory() as folder:
            server = Server(Path(folder) / "data", recorded=False)
            try:
                by_itself, through = measure(server, row, options.seconds, options.seeds)
            finally:
                server.stop()
        lost.append(100 * (through / by_itself - 1))
        print(f"| {row.name} | {by_itself:.1f} | {through:.1f} | {lost[-1]:.2f} |", flush=True)
    print(f"\nLost on the mean: {statistics.fmean(lost):.2f} %, at most {max(lost):.2f} %")


if __name__ == "__main__":
    main(sys.argv[1:])
