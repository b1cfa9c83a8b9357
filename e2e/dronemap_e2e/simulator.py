"""Simulated vehicles as a process of their own."""

import subprocess
from pathlib import Path

from .server import ROOT

SIMULATOR_JAR = ROOT / "dronemap-sim" / "target" / "dronemap-sim.jar"


class Simulator:
    """Vehicles that connect to one address; extra arguments as the simulator's own --help lists them."""

    def __init__(self, log: Path, connect: str, *arguments: str) -> None:
        assert SIMULATOR_JAR.exists(), f"{SIMULATOR_JAR} is missing: build first (./dronemap test does)"
        with log.open("ab") as output:
            self._process = subprocess.Popen(
                ["java", "-Xmx256m", "-jar", str(SIMULATOR_JAR), "--connect", connect, *arguments],
                stdout=output,
                stderr=subprocess.STDOUT,
            )

    @property
    def pid(self) -> int:
        return self._process.pid

    def stop(self) -> None:
        self._process.kill()
        self._process.wait()
