"""Reads figures of processes and sockets from the kernel."""

import os
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

TICKS = os.sysconf("SC_CLK_TCK")
PAGE = os.sysconf("SC_PAGE_SIZE")
CORES = os.cpu_count() or 1


@dataclass(frozen=True)
class Sample:
    """One moment; CPU in seconds since the start of process or machine."""

    at: float
    process: float
    threads: dict[str, float]
    machine_busy: float
    machine_all: float
    drops: int
    backlog_drops: int


def sample(pid: int, udp_port: int) -> Sample:
    busy, everything = _machine()
    drops = kernel_drops(udp_port)
    return Sample(time.monotonic(), cpu(pid), _threads(pid), busy, everything, drops, backlog_drops())


def cpu(pid: int) -> float:
    return _cpu(Path(f"/proc/{pid}/stat"))


def _cpu(stat: Path) -> float:
    fields = stat.read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def _threads(pid: int) -> dict[str, float]:
    """By name; threads of one name together."""
    used: dict[str, float] = {}
    for task in Path(f"/proc/{pid}/task").iterdir():
        try:
            name = (task / "comm").read_text().strip()
            kind = name.rstrip("0123456789-# ")
            used[kind] = used.get(kind, 0.0) + _cpu(task / "stat")
        except OSError:
            continue  # it ended meanwhile
    return used


def busy_seconds() -> float:
    """CPU that anything used since the machine started."""
    return _machine()[0]


def _machine() -> tuple[float, float]:
    fields = [int(f) for f in Path("/proc/stat").read_text().splitlines()[0].split()[1:9]]
    idle = fields[3] + fields[4]
    return (sum(fields) - idle) / TICKS, sum(fields) / TICKS


def resident_bytes(pid: int) -> int:
    return int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * PAGE


def live_heap_bytes(pid: int) -> int:
    """Bytes of a Java process's heap after a full collection, which this makes."""
    output = subprocess.run(
        ["jcmd", str(pid), "GC.class_histogram"], capture_output=True, text=True, check=True, timeout=60
    ).stdout
    return int(output.splitlines()[-1].split()[2])


def kernel_drops(udp_port: int) -> int:
    """Datagrams that the kernel threw away, as the socket's buffer was full."""
    drops = 0
    for table in ("/proc/net/udp", "/proc/net/udp6"):
        for line in Path(table).read_text().splitlines()[1:]:
            fields = line.split()
            if int(fields[1].split(":")[1], 16) == udp_port:
                drops += int(fields[-1])
    return drops


def backlog_drops() -> int:
    """Packets of the whole machine that the kernel threw away before they came to any socket."""
    lines = Path("/proc/net/softnet_stat").read_text().splitlines()
    return sum(int(line.split()[1], 16) for line in lines)


def processor() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return f"{os.cpu_count()} x {line.partition(':')[2].strip()}"
    return f"{os.cpu_count()} cores"
