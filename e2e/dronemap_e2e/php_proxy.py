"""The PHP SOAP proxy as a program of its own, before a server."""

import os
import shutil
import socket
import subprocess
from pathlib import Path

from .ports import free_port
from .server import ROOT
from .waiting import wait_for


class PhpProxy:
    """PHP's own web server with the proxy's page, its sessions in that folder."""

    def __init__(self, server_address: str, folder: Path, **settings: str) -> None:
        self.port = free_port()
        self.address = f"http://127.0.0.1:{self.port}"
        self.log = folder / "php.log"
        self.sessions = folder / "php-sessions"
        self._environment = os.environ | {
            "DRONEMAP_PHP_SERVER": server_address,
            "DRONEMAP_PHP_SESSIONS": str(self.sessions),
            "PHP_CLI_SERVER_WORKERS": "4",
        }
        self._environment |= settings
        self._process: subprocess.Popen[bytes] | None = None

    def start(self) -> None:
        with self.log.open("wb") as log:
            self._process = subprocess.Popen(
                [
                    shutil.which("php") or "php",
                    *("-d", "opcache.enable_cli=1", "-S", f"127.0.0.1:{self.port}"),
                    *("-t", ROOT / "php-soap-proxy" / "public"),
                ],
                env=self._environment,
                stdout=log,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )
        wait_for("PHP listens", self._listens, 20)

    def _listens(self) -> bool:
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", self.port)) == 0

    def stop(self) -> None:
        if self._process is not None:
            # Its workers belong to its group.
            os.killpg(self._process.pid, 15)
            self._process.wait(10)
            self._process = None
