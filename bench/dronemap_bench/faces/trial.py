"""One version measured once: calls beside a thousand vehicles, then viewers of twenty on a fresh server."""

import tempfile
import time
from contextlib import closing
from dataclasses import dataclass
from itertools import cycle
from pathlib import Path

from .. import machine
from ..programs import Json, Programs, Server
from .calls import ApiCaller, percentile, time_interleaved
from .vehicles import AcknowledgingVehicles

LEAD_SECONDS = 0.5
END_SECONDS = 60
LIVE_SECONDS = 120
# A server lets 200 ms pass between the same order to the same drone: each of these has its turn after longer.
ORDERED = 60
# One user's programs make all calls and watch all streams here, from one address.
UNBOUNDED = {
    "DRONEMAP_RATE_REQUESTS": "0",
    "DRONEMAP_RATE_COMMANDS": "0",
    "DRONEMAP_STREAMS_PER_USER": "2000",
    "DRONEMAP_CONNECTIONS_PER_ADDRESS": "2000",
}


@dataclass(frozen=True)
class Options:
    """Sizes and durations of one trial."""

    rounds: int = 5
    vehicles: int = 1_000
    warm_up_calls: int = 1_000
    calls: int = 1_000
    lists: int = 200
    commands: int = 300
    viewers: int = 1_000
    watched: int = 20
    rate: int = 5
    warm_up_seconds: float = 20
    seconds: float = 20


def measure(options: Options, jar: Path) -> Json:
    return {"calls": _calls(options, jar), "stream": _stream(options, jar)}


def _calls(options: Options, jar: Path) -> Json:
    with tempfile.TemporaryDirectory(prefix="dronemap-bench-") as folder:
        server = Server(Path(folder) / "data", recorded=False, jar=jar, settings=UNBOUNDED)
        programs = Programs()
        acknowledging = AcknowledgingVehicles(server.udp_port, ORDERED)
        try:
            pace = ("--vehicles", str(options.vehicles), "--rate", "1")
            steps = ("--steps", "3600", "--only-positions", "yes", "--hosts", "1")
            sender = programs.start("send", *pace, *steps, "--port", str(server.udp_port))
            sender.await_ready()
            sender.send_line(str(int((time.monotonic() + LEAD_SECONDS) * 1e9)))
            drones = _await_live(server, options.vehicles, acknowledging.ports)
            with closing(ApiCaller(server)) as caller:
                return _time_calls(options, caller, drones)
        finally:
            programs.stop()
            acknowledging.stop()
            server.stop()


def _await_live(server: Server, others: int, ports: list[int]) -> list[str]:
    """The ids of the drones at those ports, when these and all others are live."""
    deadline = time.monotonic() + LIVE_SECONDS
    while time.monotonic() < deadline:
        live = [drone for drone in server.get("/drones")["drones"] if drone["link"]["state"] == "live"]
        if len(live) == others + len(ports):
            return [str(drone["id"]) for drone in live if drone["link"]["port"] in ports]
        time.sleep(0.5)
    raise SystemExit(f"Not all of {others + len(ports)} vehicles were live within {LIVE_SECONDS} s")


def _time_calls(options: Options, caller: ApiCaller, drones: list[str]) -> Json:
    turns = cycle(drones)

    def one_by_rest() -> bytes:
        return caller.rest(f"/drones/{drones[0]}")

    def one_by_soap() -> bytes:
        return caller.soap("getDrone", droneId=drones[0])

    def all_by_rest() -> bytes:
        return caller.rest("/drones")

    def all_by_soap() -> bytes:
        return caller.soap("getDronesList")

    def order_by_rest() -> None:
        switch = {"type": "setRelay", "relay": 0, "setting": "on"}
        _succeeded(caller.rest(f"/drones/{next(turns)}/commands?wait=10", switch))

    def order_by_soap() -> None:
        _succeeded(caller.soap("setRelay", droneId=next(turns), relay=0, setting="on"))

    time_interleaved(options.warm_up_calls, one_by_rest, one_by_soap, order_by_rest, order_by_soap)
    time_interleaved(max(1, options.lists // 2), all_by_rest, all_by_soap)
    one = time_interleaved(options.calls, one_by_rest, one_by_soap)
    orders = time_interleaved(options.commands, order_by_rest, order_by_soap)
    lists = time_interleaved(options.lists, all_by_rest, all_by_soap)
    return {
        "oneByRest": _spread(one[0]),
        "oneBySoap": _spread(one[1]),
        "soapMoreAtP50": round(percentile(one[1], 0.5) - percentile(one[0], 0.5), 3),
        "commandByRest": _spread(orders[0]),
        "commandBySoap": _spread(orders[1]),
        "listByRest": _spread(lists[0]),
        "listBySoap": _spread(lists[1]),
    }


def _succeeded(answer: bytes) -> None:
    if b"succeeded" not in answer:
        raise SystemExit(f"A command came to nothing: {answer[:500]!r}")


def _spread(values: list[float]) -> Json:
    return {f"p{share}": round(percentile(values, share / 100), 3) for share in (50, 95, 99)}


def _stream(options: Options, jar: Path) -> Json:
    with tempfile.TemporaryDirectory(prefix="dronemap-bench-") as folder:
        server = Server(Path(folder) / "data", recorded=False, jar=jar, settings=UNBOUNDED)
        programs = Programs()
        try:
            return _measure_stream(options, server, programs)
        finally:
            programs.stop()
            server.stop()


def _measure_stream(options: Options, server: Server, programs: Programs) -> Json:
    pace = ("--vehicles", str(options.watched), "--rate", str(options.rate))
    steps = round(options.rate * (options.warm_up_seconds + options.seconds + 1))
    kind = ("--steps", str(steps), "--only-positions", "yes", "--hosts", "1")
    stream = ("--port", str(server.stream_port), "--key", server.key())
    crowd = programs.start("crowd", "--viewers", str(options.viewers), *stream)
    crowd.await_ready()
    sender = programs.start("send", *pace, *kind, "--port", str(server.udp_port))
    sender.await_ready()
    start = time.monotonic() + LEAD_SECONDS
    begin = start + options.warm_up_seconds
    end = begin + options.seconds
    sender.send_line(str(int(start * 1e9)))
    crowd.send_line(f"{int(begin * 1e9)} {int(end * 1e9)}")
    when = ("--from-nanos", str(int(begin * 1e9)), "--until-nanos", str(int(end * 1e9)))
    watcher = programs.start(
        "watch", *pace, "--hosts", "1", "--start-nanos", str(int(start * 1e9)), *stream, *when
    )
    _sleep_until(begin)
    before = machine.cpu(server.pid)
    _sleep_until(end)
    used = machine.cpu(server.pid) - before
    resident = machine.resident_bytes(server.pid)
    counted, seen = crowd.result(END_SECONDS), watcher.result(END_SECONDS)
    sent = sender.result(END_SECONDS)
    ages = {f"p{share}": seen["age"]["percentiles"][f"{share}.0"] / 1_000 for share in (50, 99)}
    return {
        "messages": counted["messages"],
        "shareOfPositions": round(
            counted["messages"] / (options.viewers * options.watched * options.rate * options.seconds), 3
        ),
        "fewest": counted["fewest"],
        "most": counted["most"],
        "ageMillis": ages,
        "cpuPercentOfOneCore": round(100 * used / options.seconds, 1),
        "cpuMicrosPerMessage": round(1e6 * used / max(1, counted["messages"]), 2),
        "residentMegabytes": round(resident / 1e6, 1),
        "sent": sent,
    }


def _sleep_until(when: float) -> None:
    time.sleep(max(0.0, when - time.monotonic()))
