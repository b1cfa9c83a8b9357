"""The processes of a measurement: server, vehicles, watcher, impairer, checker."""

import json
import os
import socket
import subprocess
import time
import urllib.error
import urllib.request
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from . import machine

ROOT = Path(__file__).resolve().parents[2]
SERVER_JAR = ROOT / "dronemap-ws" / "target" / "dronemap.jar"
LOAD_JAR = ROOT / "dronemap-sim" / "target" / "dronemap-sim.jar"
START_SECONDS = 180

Json = dict[str, Any]


def free_port(kind: socket.SocketKind = socket.SOCK_STREAM) -> int:
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


class Server:
    """A server of one measurement, in its default configuration but for ports, folder and recording."""

    def __init__(
        self,
        data: Path,
        recorded: bool = True,
        vehicles_by_web: bool = False,
        jar: Path = SERVER_JAR,
        settings: Mapping[str, str] = MappingProxyType({}),
    ) -> None:
        for needed in (jar, LOAD_JAR):
            if not needed.exists():
                raise SystemExit(f"{needed} is missing: build first (mvn -Pfast package)")
        self.http_port = free_port()
        self.stream_port = free_port()
        self.udp_port = free_port(socket.SOCK_DGRAM)
        self.outlet_udp_port = free_port(socket.SOCK_DGRAM)
        self.outlet_tcp_port = free_port()
        self.robot_udp_port = free_port(socket.SOCK_DGRAM)
        self.robot_web_port = free_port()
        self.vehicle_web_port = free_port()
        endpoints = [f"udpserver://127.0.0.1:{self.udp_port}"]
        if vehicles_by_web:
            endpoints.append(f"wsserver://127.0.0.1:{self.vehicle_web_port}")
        self._data = data
        data.mkdir(parents=True)
        options = os.environ.get("DRONEMAP_JAVA_OPTS", "").split()
        # It is the default configuration that is measured, and never on a database that is in use.
        inherited = {name: value for name, value in os.environ.items() if not name.startswith("DRONEMAP_")}
        with (data / "server.log").open("wb") as log:
            self._process = subprocess.Popen(
                ["java", "-Xmx384m", *options, "-jar", str(jar)],
                env=inherited
                | {
                    "DRONEMAP_DATA_DIR": str(data),
                    "DRONEMAP_BIND": "127.0.0.1",
                    "DRONEMAP_HTTP_PORT": str(self.http_port),
                    "DRONEMAP_STREAM_PORT": str(self.stream_port),
                    "DRONEMAP_ENDPOINTS": ",".join(endpoints),
                    "DRONEMAP_OUTLET": f"udpserver://127.0.0.1:{self.outlet_udp_port},"
                    f"tcpserver://127.0.0.1:{self.outlet_tcp_port}",
                    "DRONEMAP_ROBOTS": f"udpserver://127.0.0.1:{self.robot_udp_port},"
                    f"wsserver://127.0.0.1:{self.robot_web_port}",
                    "DRONEMAP_RECORD": "flights" if recorded else "never",
                    # Every recording is fetched at once afterwards, to be compared with what was sent.
                    "DRONEMAP_RATE_EXPORTS": "0",
                }
                | dict(settings),
                stdout=log,
                stderr=subprocess.STDOUT,
            )
        self._wait()

    @property
    def pid(self) -> int:
        return self._process.pid

    def key(self) -> str:
        return (self._data / "local-key").read_text().strip()

    def get(self, path: str) -> Json:
        answer: Json = json.loads(self.read(path))
        return answer

    def frames_in(self) -> int:
        endpoints: list[Json] = self.get("/endpoints")["endpoints"]
        return sum(int(endpoint["counts"]["framesIn"]) for endpoint in endpoints)

    def read(self, path: str) -> bytes:
        request = urllib.request.Request(
            f"http://127.0.0.1:{self.http_port}/api/v1{path}",
            headers={"Authorization": f"Bearer {self.key()}"},
        )
        with urllib.request.urlopen(request, timeout=60) as answer:
            body: bytes = answer.read()
            return body

    def download(self, path: str, to: Path) -> None:
        request = urllib.request.Request(
            f"http://127.0.0.1:{self.http_port}/api/v1{path}",
            headers={"Authorization": f"Bearer {self.key()}"},
        )
        with urllib.request.urlopen(request, timeout=60) as answer, to.open("wb") as out:
            while block := answer.read(1 << 20):
                out.write(block)

    def stop(self) -> None:
        self._process.terminate()
        try:
            self._process.wait(30)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()

    def _wait(self) -> None:
        deadline = time.monotonic() + START_SECONDS
        while time.monotonic() < deadline:
            if self._process.poll() is not None:
                raise SystemExit(f"The server ended; see {self._data / 'server.log'}")
            try:
                url = f"http://127.0.0.1:{self.http_port}/api/v1/health"
                with urllib.request.urlopen(url, timeout=2) as answer:
                    if json.loads(answer.read())["status"] == "up":
                        return
            except (OSError, urllib.error.URLError):
                time.sleep(0.2)
        raise SystemExit("The server did not start in time")


class Programs:
    """The load programs of one measurement, to be stopped together."""

    def __init__(self, *running: "Load | None") -> None:
        self._all = [program for program in running if program is not None]
        self._own: list[Load] = []

    def start(self, *arguments: str, niceness: int = 0) -> "Load":
        program = Load(*arguments, niceness=niceness)
        self._all.append(program)
        self._own.append(program)
        return program

    def cpu(self) -> float:
        return sum(machine.cpu(program.pid) for program in self._all)

    def stop(self) -> None:
        for program in self._own:
            program.stop()


class Load:
    """One of the load programs; its result is the line of JSON that it prints at its end."""

    def __init__(self, *arguments: str, niceness: int = 0) -> None:
        self._process = subprocess.Popen(
            [
                "nice",
                "-n",
                str(niceness),
                "java",
                "-Xmx512m",
                "-cp",
                str(LOAD_JAR),
                "org.dronemap.sim.load.LoadMain",
                *arguments,
            ],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    @property
    def pid(self) -> int:
        return self._process.pid

    def await_ready(self) -> None:
        """Waits until the program has printed that it is ready."""
        self.await_line("ready")

    def await_line(self, word: str) -> None:
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        if line.strip() != word:
            raise SystemExit(f"A load program said '{line}' instead of '{word}'")

    def send_line(self, line: str) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write(line + "\n")
        self._process.stdin.flush()

    def result(self, seconds: float) -> Json:
        output, _ = self._process.communicate(timeout=seconds)
        if self._process.returncode != 0:
            raise SystemExit(f"A load program failed with {self._process.returncode}: {output}")
        result: Json = json.loads(output.splitlines()[-1])
        return result

    def stop(self) -> None:
        if self._process.poll() is None:
            self._process.kill()
            self._process.wait()
