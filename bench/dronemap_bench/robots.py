"""`python -m dronemap_bench.robots`: many robots, half of them on WebSockets, and what of theirs arrived."""

import argparse
import json
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from . import machine
from .programs import Json, Load, Server

LEAD_SECONDS = 0.5
END_SECONDS = 60
FIRST_SYSTEM_ID = 1000
# The server has compiled what it needs, and opened its heap, by then.
WARM_SHARE = 3


def measure(robots: int, rate: int, seconds: int) -> Json:
    with tempfile.TemporaryDirectory(prefix="dronemap-bench-") as folder:
        server = Server(Path(folder) / "data")
        try:
            return _measure(server, robots, rate, seconds)
        finally:
            server.stop()


def _measure(server: Server, robots: int, rate: int, seconds: int) -> Json:
    idle = machine.resident_bytes(server.pid)
    ports = ["--port", str(server.robot_udp_port), "--web-port", str(server.robot_web_port)]
    sender = Load(
        "robots", *ports, *("--robots", str(robots), "--rate", str(rate), "--steps", str(rate * seconds))
    )
    try:
        sender.await_ready()
        start = time.monotonic() + LEAD_SECONDS
        sender.send_line(str(int(start * 1e9)))
        time.sleep(max(0.0, start + seconds / WARM_SHARE - time.monotonic()))
        before, frames = machine.sample(server.pid, server.robot_udp_port), _frames_received(server)
        early = machine.resident_bytes(server.pid)
        sender.await_line("said")
        after, frames_after = machine.sample(server.pid, server.robot_udp_port), _frames_received(server)
        late = machine.resident_bytes(server.pid)
        arrived = _count_arrived(server, robots, rate * seconds)
        frames_at_end = _frames_received(server)
        sender.send_line("all came")
        sender.await_line("beaten")
        _wait_until(lambda: _frames_received(server) >= frames_at_end + robots)
        counts = _counts(server)
        sender.send_line("end")
        sent = sender.result(END_SECONDS)
    finally:
        sender.stop()
    wall = after.at - before.at
    return {
        "robots": robots,
        "rate": rate,
        "seconds": seconds,
        "sent": sent,
        "received": {transport: of["framesIn"] for transport, of in counts.items()},
        "missingNumbers": sum(of["lost"] for of in counts.values()),
        "dropped": sum(of["droppedIn"] for of in counts.values()),
        "broken": sum(of["brokenBytes"] for of in counts.values()),
        "kernelDrops": after.drops,
        "arrived": arrived,
        "cpuPercentOfOneCore": round(100 * (after.process - before.process) / wall, 1),
        "cpuMicrosPerMessage": round(
            1e6 * (after.process - before.process) / max(1, frames_after - frames), 1
        ),
        "idleMegabytes": round(idle / 1e6, 1),
        "warmMegabytes": round(early / 1e6, 1),
        "lateMegabytes": round(late / 1e6, 1),
    }


def _counts(server: Server) -> dict[str, Json]:
    return {
        each["url"].partition(":")[0]: each["counts"]
        for each in server.get("/endpoints")["endpoints"]
        if each["url"].endswith((f":{server.robot_udp_port}", f":{server.robot_web_port}"))
    }


def _frames_received(server: Server) -> int:
    return sum(int(counts["framesIn"]) for counts in _counts(server).values())


def _count_arrived(server: Server, robots: int, steps: int) -> int:
    """Counts robots that are shown where they reported last, each in its own row."""
    found = 0

    def count() -> bool:
        nonlocal found
        found = 0
        for drone in server.get("/drones")["drones"]:
            number = drone["link"]["systemId"] - FIRST_SYSTEM_ID
            place = drone["local"] or {}
            found += (place.get("x"), place.get("y")) == (steps, number)
        return found == robots

    _wait_until(count)
    return found


def _wait_until(is_so: Callable[[], bool]) -> None:
    deadline = time.monotonic() + END_SECONDS
    while not is_so() and time.monotonic() < deadline:
        time.sleep(0.5)


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="python -m dronemap_bench.robots", description=__doc__)
    parser.add_argument("--robots", type=int, default=500)
    parser.add_argument("--rate", type=int, default=10, help="messages of each a second")
    parser.add_argument("--seconds", type=int, default=300)
    options = parser.parse_args(arguments)
    print(json.dumps(measure(options.robots, options.rate, options.seconds), indent=2))


if __name__ == "__main__":
    main(sys.argv[1:])
