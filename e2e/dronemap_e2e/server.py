"""A Dronemap server of the test's own: fresh data, free ports, killed at the end."""

import os
import signal
import socket
import subprocess
from pathlib import Path
from typing import Any

import requests

from . import server_template
from .ports import free_port
from .waiting import wait_for

ROOT = Path(__file__).resolve().parents[2]
# Half of what a start costs is work of the second compiler, which pays only where a server runs for long.
QUICK = "-XX:TieredStopAtLevel=1"
# Its faces answer a little before its ports for ground stations do; this it says when all do.
READY = b" is ready at "
SERVER_JAR = ROOT / "dronemap-ws" / "target" / "dronemap.jar"


class Server:
    """One server process; it may be killed and started again over the same data."""

    def __init__(
        self,
        data: Path,
        as_shipped: bool = False,
        copy_initial_data: bool = True,
        heap: str = "384m",
        **settings: str,
    ) -> None:
        """`as_shipped`: for tests that measure it; `begun`: where no folder is yet, it is a copy of what
        a first start leaves, which is quicker than another; `heap`: its most, as Java has it."""
        self.data = data
        self._begun = copy_initial_data and "DRONEMAP_DATABASE_URL" not in settings
        self._options = [f"-Xmx{heap}", *([] if as_shipped else [QUICK])]
        self.http_port = free_port()
        self.stream_port = free_port()
        self.udp_port = free_port(socket.SOCK_DGRAM)
        self.tcp_port = free_port()
        self.outlet_udp_port = free_port(socket.SOCK_DGRAM)
        self.outlet_tcp_port = free_port()
        self.outlet_dtls_port = free_port(socket.SOCK_DGRAM)
        self.outlet_web_socket_port = free_port()
        self.robot_udp_port = free_port(socket.SOCK_DGRAM)
        self.robot_web_port = free_port()
        self._settings = settings
        self._process: subprocess.Popen[bytes] | None = None
        self._log_offset = 0

    @property
    def address(self) -> str:
        scheme = "https" if self.authority else "http"
        return f"{scheme}://{self.host}:{self.http_port}"

    @property
    def host(self) -> str:
        return self._settings.get("DRONEMAP_BIND", "127.0.0.1")

    @property
    def stream_address(self) -> str:
        return f"ws://{self.host}:{self.stream_port}/stream"

    @property
    def authority(self) -> str | None:
        """The file of who signed its certificate; None: it speaks plain HTTP."""
        return self._settings.get("DRONEMAP_TLS_AUTHORITY")

    @property
    def pid(self) -> int:
        assert self._process is not None
        return self._process.pid

    def runs(self) -> bool:
        return self._process is not None and self._process.poll() is None

    def start_unless_it_runs(self) -> None:
        if not self.runs():
            self.start()

    def start(self) -> None:
        self.begin()
        try:
            wait_for("the server is up", self.is_up, seconds=180)
        except BaseException:
            self.stop()
            raise

    def begin(self) -> None:
        """Does not wait until it is up."""
        jar = server_template.unpacked(SERVER_JAR)
        if self._begun and not self.data.exists():
            server_template.copy_initial_data(SERVER_JAR, self.data, _first_start)
        self.data.mkdir(parents=True, exist_ok=True)
        # A developer's own settings, above all a database, are nothing for tests.
        inherited = {name: value for name, value in os.environ.items() if not name.startswith("DRONEMAP_")}
        environment = inherited | {
            "DRONEMAP_DATA_DIR": str(self.data),
            "DRONEMAP_BIND": "127.0.0.1",
            "DRONEMAP_HTTP_PORT": str(self.http_port),
            "DRONEMAP_STREAM_PORT": str(self.stream_port),
            "DRONEMAP_ENDPOINTS": (
                f"udpserver://127.0.0.1:{self.udp_port},tcpserver://127.0.0.1:{self.tcp_port}"
            ),
            "DRONEMAP_OUTLET": (
                f"udpserver://127.0.0.1:{self.outlet_udp_port},tcpserver://127.0.0.1:{self.outlet_tcp_port}"
                f",dtlsserver://127.0.0.1:{self.outlet_dtls_port}"
                f",wsserver://127.0.0.1:{self.outlet_web_socket_port}"
            ),
            "DRONEMAP_ROBOTS": (
                f"udpserver://127.0.0.1:{self.robot_udp_port},wsserver://127.0.0.1:{self.robot_web_port}"
            ),
        }
        with self._log.open("ab") as log:
            self._log_offset = log.tell()
            self._process = subprocess.Popen(
                ["java", *self._options, "-jar", str(jar)],
                env=environment | self._settings,
                stdout=log,
                stderr=subprocess.STDOUT,
            )

    def kill(self) -> None:
        """kill -9: no chance to tidy up."""
        assert self._process is not None
        self._process.send_signal(signal.SIGKILL)
        self._process.wait()

    def stop(self) -> None:
        if self._process is not None and self.runs():
            self._process.terminate()
            try:
                self._process.wait(20)
            except subprocess.TimeoutExpired:
                self.kill()

    def local_key(self) -> str:
        return (self.data / "local-key").read_text().strip()

    def first_password(self) -> str:
        return (self.data / "first-password.txt").read_text().split()[1]

    def log(self) -> str:
        return self._log.read_text(errors="replace")

    def is_up(self) -> bool:
        assert self._process is not None
        assert self._process.poll() is None, f"the server ended: {self._tail()}"
        try:
            answer = requests.get(self.address + "/api/v1/health", timeout=2, verify=self.authority or True)
        except (requests.ConnectionError, requests.Timeout):
            return False
        body: dict[str, Any] = answer.json() if answer.ok else {}
        return body.get("status") == "up" and READY in self._log.read_bytes()[self._log_offset :]

    @property
    def _log(self) -> Path:
        return self.data / "server.log"

    def _tail(self) -> str:
        return self.log()[-2000:]


def _first_start(data: Path) -> None:
    server = Server(data, copy_initial_data=False)
    server.start()
    server.stop()
    (data / "server.log").unlink()
