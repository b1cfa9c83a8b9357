"""One configuration measured on a fresh server."""

import os
import socket
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from . import machine, outlet
from .configurations import Configuration
from .programs import Json, Load, Programs, Server, free_port

LEAD_SECONDS = 0.5
END_SECONDS = 90
SHOWN_THREADS = 10


def measure(configuration: Configuration) -> Json:
    """All figures of one configuration."""
    with tempfile.TemporaryDirectory(prefix="dronemap-bench-") as folder:
        server = Server(Path(folder) / "data", configuration.recorded)
        try:
            return _measure(configuration, server, Path(folder))
        finally:
            server.stop()


def _measure(c: Configuration, server: Server, folder: Path) -> Json:
    time.sleep(2)
    passphrases = outlet.passphrases(server, c.clients.count + c.clients.stuck) if c.clients else []
    idle_bytes = machine.resident_bytes(server.pid)
    pace = ["--vehicles", str(c.vehicles), "--rate", str(c.rate)]
    hosts = ["--hosts", str(c.hosts)]
    kind = ["--steps", str(c.steps()), "--only-positions", "yes" if c.only_positions else "no"]
    with _network(c, server) as (port, network):
        programs = Programs(network)
        try:
            sender = programs.start("send", *pace, *kind, *hosts, "--port", str(port))
            sender.await_ready()
            start = time.monotonic() + LEAD_SECONDS
            begin = start + c.warm_up
            end = begin + c.seconds + c.settle_seconds
            disturbed = begin + c.seconds / 2
            settled = disturbed + c.settle_seconds
            sender.send_line(str(int(start * 1e9)))
            _sleep_until(begin - 3)
            paced = [*pace, "--start-nanos", str(int(start * 1e9))]
            where = [*paced, *hosts, "--port", str(server.stream_port), "--key", server.key()]
            watcher = programs.start("watch", *where, *_between(settled if c.halved else begin, end))
            calm = programs.start("watch", *where, *_between(begin, disturbed)) if c.halved else None
            flooder = _flooder(c, programs, port, (disturbed, end))
            _sleep_until(begin)
            before, frames_before = machine.sample(server.pid, server.udp_port), server.frames_in()
            own_before = programs.cpu()
            _sleep_until(disturbed)
            middle_bytes = machine.resident_bytes(server.pid)
            clients = _clients(c, programs, server, passphrases, paced, (settled, end))
            _sleep_until(end)
            after, frames_after = machine.sample(server.pid, server.udp_port), server.frames_in()
            own_after = programs.cpu()
            busy_bytes = machine.resident_bytes(server.pid)
            live = _live(server)
            ends = {
                "sent": sender.result(END_SECONDS),
                "stream": watcher.result(END_SECONDS),
                "calm": calm.result(END_SECONDS) if calm else None,
                "flood": flooder.result(END_SECONDS) if flooder else None,
                "clients": clients.result(END_SECONDS) if clients else None,
            }
        finally:
            programs.stop()
        tlogs = _check(c, server, folder, [*pace, *kind])
    figures = _figures(frames_after - frames_before, before, after, own_after - own_before)
    return figures | {
        "name": c.name,
        "what": c.what,
        "vehicles": c.vehicles,
        "rate": c.rate,
        "seconds": c.seconds,
        "measuredSeconds": c.seconds / 2 if c.halved else c.seconds,
        "impaired": c.impairment is not None,
        "live": live,
        **ends,
        "tlogs": tlogs,
        "idleMegabytes": round(idle_bytes / 1e6, 1),
        "middleMegabytes": round(middle_bytes / 1e6, 1),
        "busyMegabytes": round(busy_bytes / 1e6, 1),
        "kilobytesPerDrone": round((busy_bytes - idle_bytes) / c.vehicles / 1e3, 1),
    }


def _figures(messages: int, before: machine.Sample, after: machine.Sample, others: float) -> Json:
    """Figures by message that the server received meanwhile: a late sender must not make it look cheap."""
    wall = after.at - before.at
    used = after.process - before.process
    busy = after.machine_busy - before.machine_busy
    threads = {
        name: round(100 * (spent - before.threads.get(name, 0.0)) / wall, 2)
        for name, spent in after.threads.items()
    }
    top = sorted(threads.items(), key=lambda each: -each[1])[:SHOWN_THREADS]
    return {
        "cpuPercentOfOneCore": round(100 * used / wall, 1),
        "heardPerSecond": round(messages / wall),
        "cpuMicrosPerMessage": round(1e6 * used / max(1, messages), 2),
        "compilerMicrosPerMessage": round(1e6 * _compiling(before, after) / max(1, messages), 2),
        "threadsPercentOfOneCore": dict(top),
        "kernelDrops": after.drops - before.drops,
        "kernelDropsWhileWarmingUp": before.drops,
        "backlogDrops": after.backlog_drops - before.backlog_drops,
        "foreignLoadPercentOfMachine": round(
            100 * max(0.0, busy - used - others) / (after.machine_all - before.machine_all), 1
        ),
        "loadAverage": os.getloadavg()[0],
    }


def _compiling(before: machine.Sample, after: machine.Sample) -> float:
    """CPU seconds of the virtual machine's own compiler, busy with a young server."""
    return sum(
        spent - before.threads.get(name, 0.0)
        for name, spent in after.threads.items()
        if "CompilerThre" in name
    )


@contextmanager
def _network(c: Configuration, server: Server) -> Iterator[tuple[int, Load | None]]:
    """The port that vehicles send to, and what spoils the way from there to the server."""
    if c.impairment is None:
        yield server.udp_port, None
        return
    port = free_port(socket.SOCK_DGRAM)
    impairer = Load(
        "impair", "--listen", str(port), "--port", str(server.udp_port), *c.impairment.arguments()
    )
    try:
        yield port, impairer
    finally:
        impairer.stop()


def _between(begin: float, end: float) -> list[str]:
    return ["--from-nanos", str(int(begin * 1e9)), "--until-nanos", str(int(end * 1e9))]


def _flooder(c: Configuration, programs: Programs, port: int, when: tuple[float, float]) -> Load | None:
    if c.flood is None:
        return None
    return programs.start("flood", "--port", str(port), *_between(*when), *c.flood.arguments())


def _clients(
    c: Configuration,
    programs: Programs,
    server: Server,
    passphrases: list[str],
    paced: list[str],
    when: tuple[float, float],
) -> Load | None:
    if c.clients is None:
        return None
    ports = ["--port", str(server.outlet_udp_port), "--tcp-port", str(server.outlet_tcp_port)]
    keys = ["--passphrases", ",".join(passphrases)]
    # Ground stations run elsewhere: their own work on this machine must not pass for the server's.
    return programs.start(
        "attach", *ports, *keys, *paced, *_between(*when), *c.clients.arguments(), niceness=10
    )


def _live(server: Server) -> int:
    drones: list[dict[str, Any]] = server.get("/drones")["drones"]
    return sum(d["link"]["state"] == "live" for d in drones)


def _check(c: Configuration, server: Server, folder: Path, pace: list[str]) -> Json:
    """Downloads every recording once all have ended, and compares them with what was sent."""
    if not c.recorded:
        return {"recordings": 0, "found": 0, "expected": 0}
    deadline = time.monotonic() + END_SECONDS
    while True:
        recordings = server.get("/recordings")["recordings"]
        if all(r["state"] != "running" for r in recordings) or time.monotonic() > deadline:
            break
        time.sleep(0.5)
    tlogs = folder / "tlogs"
    tlogs.mkdir()
    for recording in recordings:
        server.download(f"/recordings/{recording['id']}/file", tlogs / f"{recording['id']}.tlog")
    result = Load("check", *pace, "--folder", str(tlogs)).result(END_SECONDS)
    return result | {
        "recordings": len(recordings),
        "complete": sum(r["state"] == "complete" for r in recordings),
        "drops": sum(r["drops"] for r in recordings),
        "bytes": sum(r["bytes"] for r in recordings),
    }


def _sleep_until(when: float) -> None:
    time.sleep(max(0.0, when - time.monotonic()))
