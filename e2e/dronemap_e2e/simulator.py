"""Simulated vehicles as a process of their own."""

import socket
import subprocess
from pathlib import Path

from .ports import free_port
from .server import QUICK, ROOT
from .waiting import wait_for

GROUND_STATION_TIMEOUT = 5  # seconds, as of the real ones
# Comes home low, waits for nothing there, and sets down three times as fast as it would by itself.
LOW_AND_QUICK_RETURN = (
    *("--parameter", "RTL_ALT=800", "--parameter", "RTL_LOIT_TIME=0", "--parameter", "LAND_SPEED=150"),
)
# Five times as fast as life.
QUICK_FLIGHT = ("--speedup", "5", *LOW_AND_QUICK_RETURN)
SIMULATOR_JAR = ROOT / "dronemap-sim" / "target" / "dronemap-sim.jar"


def _speedup(arguments: tuple[str, ...]) -> float:
    return float(arguments[arguments.index("--speedup") + 1]) if "--speedup" in arguments else 1


class Simulator:
    """Vehicles that connect to one address; extra arguments as the simulator's own --help lists them."""

    def __init__(self, log: Path, connect: str, *arguments: str, as_shipped: bool = False) -> None:
        """`as_shipped`: for tests that measure it."""
        assert SIMULATOR_JAR.exists(), f"{SIMULATOR_JAR} is missing: build first (./dronemap test does)"
        self._control = free_port()
        if not {"px4", "mixed", "arduplane"} & set(arguments):
            # Time runs faster for them than for the server: a copter that is armed on the ground must not be
            # disarmed again within what is a second on a slow machine (0: never), and the server, whose
            # heartbeat comes once in a second of ours, must not be lost for it.
            timeout = GROUND_STATION_TIMEOUT * _speedup(arguments)
            own = ("--parameter", "DISARM_DELAY=0", "--parameter", f"FS_GCS_TIMEOUT={timeout:g}")
            arguments = (*own, *arguments)
        options = ["--connect", connect, "--control", str(self._control), *arguments]
        quick = [] if as_shipped else [QUICK]
        with log.open("ab") as output:
            self._process = subprocess.Popen(
                ["java", "-Xmx256m", *quick, "-jar", str(SIMULATOR_JAR), *options],
                stdout=output,
                stderr=subprocess.STDOUT,
            )

    @property
    def pid(self) -> int:
        return self._process.pid

    def fault(self, words: str) -> None:
        """Orders a fault: "7 alter RTL_ALT", "all silent 10s" …"""
        answer = self.send_command(f"fault {words}")
        assert answer.startswith("ok"), answer

    def payload(self, system_id: int) -> str:
        """Counts of a vehicle's camera and relays: "pictures 1 relays on: 0"."""
        return self._line("payload", system_id)

    def armed(self, system_id: int) -> bool:
        return " armed " in self._line("list", system_id)

    def place(self, system_id: int) -> tuple[float, float, float]:
        """True place of a vehicle: latitude and longitude in degrees, metres above its home."""
        latitude, longitude, height = map(float, self._line("where", system_id).split())
        return latitude, longitude, height

    def _line(self, words: str, system_id: int) -> str:
        lines = self.send_command(words).splitlines()
        return next(line.split(" ", 1)[1] for line in lines if line.startswith(f"{system_id} "))

    def send_command(self, words: str) -> str:
        """The answer of the control port, up to the line that ends it."""
        port = self.dial()
        with port, port.makefile("rw", encoding="utf-8", newline="\n") as line:
            line.write(f"{words}\n")
            line.flush()
            answer = ""
            for part in line:
                answer += part
                if part.startswith(("ok", "err")):
                    break
        return answer

    def dial(self) -> socket.socket:
        """The control port, for many commands one after the other."""
        return wait_for("the control port is open", self._connect, 20)

    def _connect(self) -> socket.socket | None:
        try:
            return socket.create_connection(("127.0.0.1", self._control), timeout=5)
        except ConnectionRefusedError:
            return None

    def stop(self) -> None:
        self._process.kill()
        self._process.wait()
