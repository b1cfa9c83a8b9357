"""One run: rounds of attacks on each WebSocket port, each after a calm, and the others going on meanwhile."""

import json
import os
import subprocess
import sys
import tempfile
import time
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from .. import machine
from ..programs import ROOT, Json, Server
from .others import Sample

SETTLE_SECONDS = 1.5
START_SECONDS = 3
END_SECONDS = 30
OTHERS = ("viewers", "vehicles", "calls")
CALM, CONTROL = "calm", "control"


@dataclass(frozen=True)
class Options:
    """Sizes and durations of one run."""

    rounds: int = 5
    warm_up_seconds: float = 20
    calm_seconds: float = 4
    megabytes: int = 2_000
    least_seconds: float = 5
    most_seconds: float = 7
    strangers: int = 20
    niceness: int = 10
    many_addresses: bool = False


class Program:
    """A process of `dronemap_bench.strangers`, which reads and writes lines."""

    def __init__(self, module: str, *arguments: str, niceness: int = 0) -> None:
        self._process = subprocess.Popen(
            [
                "nice",
                "-n",
                str(niceness),
                sys.executable,
                "-m",
                f"dronemap_bench.strangers.{module}",
                *arguments,
            ],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=os.environ | {"PYTHONPATH": str(ROOT / "bench")},
        )

    def cpu(self) -> float:
        return machine.cpu(self._process.pid)

    def read_line(self) -> str:
        assert self._process.stdout is not None
        line = self._process.stdout.readline().strip()
        if not line:
            raise SystemExit(f"A program ended early, with {self._process.wait(END_SECONDS)}")
        return line

    def expect(self, word: str) -> None:
        if (line := self.read_line()) != word:
            raise SystemExit(f"A program said '{line}' instead of '{word}'")

    def send_line(self, line: str) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write(line + "\n")
        self._process.stdin.flush()

    def result(self) -> Json:
        """Ends it."""
        output, _ = self._process.communicate(timeout=END_SECONDS)
        if self._process.returncode != 0:
            raise SystemExit(f"A program failed with {self._process.returncode}")
        result: Json = json.loads(output.splitlines()[-1])
        return result

    def stop(self) -> None:
        if self._process.poll() is None:
            self._process.kill()
            self._process.wait()


@dataclass(frozen=True)
class AttackedPort:
    """An attacked port, and the messages that strangers send there."""

    name: str
    port: int
    path: str
    opcode: int


def run(options: Options) -> Json:
    with tempfile.TemporaryDirectory(prefix="dronemap-bench-") as folder:
        server = Server(Path(folder) / "data", recorded=False, vehicles_by_web=True)
        programs: list[Program] = []
        try:
            return _run(options, server, programs)
        finally:
            for program in programs:
                program.stop()
            server.stop()


def _run(options: Options, server: Server, programs: list[Program]) -> Json:
    sink = Program("sink", niceness=options.niceness)
    programs.append(sink)
    targets = [
        AttackedPort("stream", server.stream_port, "/stream", 1),
        AttackedPort("robots", server.robot_web_port, "/", 1),
        AttackedPort("vehicles", server.vehicle_web_port, "/", 2),
        AttackedPort(CONTROL, int(sink.read_line()), "/", 2),
    ]
    others = _others(server, programs)
    time.sleep(options.warm_up_seconds)
    for target in targets:  # The first of each kind costs compiling, which is nobody's attack.
        _attack(target, _short(options), server, programs, {})
    windows = []
    for number in range(1, options.rounds + 1):
        print(f"round {number} of {options.rounds}", file=sys.stderr, flush=True)
        for target in targets:
            # Right before each, as what else the machine does changes from one minute to the next.
            windows.append(_calm(options, server, others) | {"round": number, "before": target.name})
            windows.append(_attack(target, options, server, programs, others) | {"round": number})
    live = sum(drone["link"]["state"] == "live" for drone in server.get("/drones")["drones"])
    samples = {who: program.result()["samples"] for who, program in others.items()}
    for window in windows:
        window["late"] = {who: _spread(samples[who], window["from"], window["until"]) for who in OTHERS}
    return {"windows": windows, "liveVehiclesAtTheEnd": live, "options": asdict(options)}


def _short(options: Options) -> Options:
    return replace(options, megabytes=1_000_000, least_seconds=0, most_seconds=min(3, options.most_seconds))


def _others(server: Server, programs: list[Program]) -> dict[str, Program]:
    start = ["--start", str(time.monotonic() + START_SECONDS)]
    key = ["--key", server.key()]
    others = {
        "vehicles": Program("others", "vehicles", "--port", str(server.vehicle_web_port), *start),
        "viewers": Program("others", "viewers", "--port", str(server.stream_port), *start, *key),
        "calls": Program("others", "calls", "--port", str(server.http_port), *start, *key),
    }
    programs.extend(others.values())
    for program in others.values():
        program.expect("ready")
    return others


def _calm(options: Options, server: Server, others: dict[str, Program]) -> Json:
    time.sleep(SETTLE_SECONDS)
    meter = CpuMeter(server, others, None)
    time.sleep(options.calm_seconds)
    return meter.window(CALM) | {"liveHeapMegabytes": _live_heap(server)}


def _attack(
    target: AttackedPort,
    options: Options,
    server: Server,
    programs: list[Program],
    others: dict[str, Program],
) -> Json:
    time.sleep(SETTLE_SECONDS)
    attack = Program(
        *("attack", "--port", str(target.port), "--path", target.path, "--opcode", str(target.opcode)),
        *("--strangers", str(options.strangers), "--megabytes", str(options.megabytes)),
        *("--least-seconds", str(options.least_seconds), "--most-seconds", str(options.most_seconds)),
        *(["--many-addresses"] if options.many_addresses else []),
        niceness=options.niceness,
    )
    programs.append(attack)
    attack.expect("ready")
    meter = CpuMeter(server, others, attack)
    attack.send_line("begin")
    attack.expect("sent")
    window = meter.window(target.name)
    # They go on: what they make the server keep is there now.
    live = _live_heap(server)
    attack.send_line("end")
    sent = attack.result()
    programs.remove(attack)
    return window | {"liveHeapMegabytes": live, "attack": sent}


def _live_heap(server: Server) -> float:
    return round(machine.live_heap_bytes(server.pid) / 1e6, 1)


class CpuMeter:
    """From now on: the processor's time of server, strangers and all others."""

    def __init__(self, server: Server, others: dict[str, Program], attack: Program | None) -> None:
        self._server = server
        self._own = list(others.values())
        self._attack = attack
        self._from = time.monotonic()
        self._before = self._read()

    def _read(self) -> tuple[float, float, float, float]:
        return (
            machine.cpu(self._server.pid),
            self._attack.cpu() if self._attack else 0.0,
            sum(program.cpu() for program in self._own),
            machine.busy_seconds(),
        )

    def window(self, name: str) -> Json:
        until = time.monotonic()
        server, attack, own, busy = (
            after - before for after, before in zip(self._read(), self._before, strict=True)
        )
        wall = until - self._from
        return {
            "what": name,
            "from": self._from,
            "until": until,
            "serverPercentOfOneCore": round(100 * server / wall),
            "strangersPercentOfOneCore": round(100 * attack / wall),
            "elsePercentOfOneCore": round(100 * max(0.0, busy - server - attack - own) / wall),
            "loadAverage": os.getloadavg()[0],
        }


def _spread(samples: list[Sample], since: float, until: float) -> dict[str, Any]:
    late = sorted(ms for when, ms in samples if since <= when < until)
    if not late:
        raise SystemExit("Nothing was measured of the others: did they lose their connections?")
    return {
        "count": len(late),
        "p50": round(late[len(late) // 2], 2),
        "p99": round(late[min(len(late) - 1, int(len(late) * 0.99))], 2),
        "most": round(late[-1], 2),
    }
