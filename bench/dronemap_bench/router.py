"""The same load through mavlink-router, when a binary of it is given: what forwarding alone costs there."""

import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from . import machine
from .configurations import Configuration
from .programs import Json, Load, free_port

LEAD_SECONDS = 0.5
END_SECONDS = 90


def measure(c: Configuration, binary: Path) -> Json:
    """Its CPU by message, and how much of what was sent came out at its other end."""
    into, out = free_port(socket.SOCK_DGRAM), free_port(socket.SOCK_DGRAM)
    sink = Load("sink", "--port", str(out))
    sender = _sender(c, into)
    try:
        with _running(binary, into, out) as pid:
            sender.await_ready()
            start = time.monotonic() + LEAD_SECONDS
            sender.send_line(str(int(start * 1e9)))
            sent = sender.result(c.warm_up + c.seconds + END_SECONDS)
            time.sleep(1)
            used, wall = machine.cpu(pid), time.monotonic() - start
            received = sink.result(END_SECONDS)
    finally:
        sender.stop()
        sink.stop()
    return {
        "cpuMicrosPerMessage": round(1e6 * used / sent["sent"], 2),
        "cpuPercentOfOneCore": round(100 * used / wall, 1),
        "sent": sent["sent"],
        "received": received["received"],
    }


def _sender(c: Configuration, port: int) -> Load:
    pace = ["--vehicles", str(c.vehicles), "--rate", str(c.rate), "--steps", str(c.steps())]
    return Load("send", *pace, "--only-positions", "yes" if c.only_positions else "no", "--port", str(port))


@contextmanager
def _running(binary: Path, into: int, out: int) -> Iterator[int]:
    process = subprocess.Popen(
        [str(binary), "-t", "0", "-e", f"127.0.0.1:{out}", f"127.0.0.1:{into}"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        time.sleep(1)
        if process.poll() is not None:
            raise SystemExit(f"{binary} ended at once with {process.returncode}")
        yield process.pid
    finally:
        process.terminate()
        process.wait()
