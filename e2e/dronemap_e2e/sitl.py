"""A real ArduCopter in software, and a receiver of its true position; needs its binary."""

import os
import socket
import subprocess
import threading
import time
from pathlib import Path
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from .api import Api
from .ports import free_port
from .runs import Track

BINARY = os.environ.get("DRONEMAP_SITL_ARDUCOPTER")
RECEIVER_SYSTEM_ID = 200
ASK_EVERY_SECONDS = 2.0
REPORT_MICROS = 100_000


class GroundTruthReceiver:
    """Receives one vehicle's simulated state on a port that the server has no part in."""

    def __init__(self) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self._socket.settimeout(0.2)
        self.port: int = self._socket.getsockname()[1]
        self._parser = mavlink.MAVLink(None)
        self._parser.robust_parsing = True
        self._encoder = mavlink.MAVLink(None, srcSystem=RECEIVER_SYSTEM_ID)
        self._asked = 0.0
        self._lock = threading.Lock()
        self._positions: list[tuple[float, float, float, float]] = []
        self._closed = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def positions(self) -> list[tuple[float, float, float, float]]:
        """Monotonic seconds, degrees, and metres above the sea, ten times a second."""
        with self._lock:
            return list(self._positions)

    def track(self) -> Track:
        return [fix[1:] for fix in self.positions()]

    def altitude(self) -> float:
        """Above the sea, now."""
        with self._lock:
            return self._positions[-1][3]

    def close(self) -> None:
        self._closed = True
        self._thread.join()
        self._socket.close()

    def _run(self) -> None:
        while not self._closed:
            try:
                data, sender = self._socket.recvfrom(65535)
            except TimeoutError:
                continue
            for message in self._parser.parse_buffer(data) or []:
                self._apply(message, sender)

    def _apply(self, message: Any, sender: tuple[str, int]) -> None:
        now = time.monotonic()
        if message.get_type() == "SIM_STATE":
            fix = (now, message.lat_int / 1e7, message.lon_int / 1e7, message.alt)
            with self._lock:
                self._positions.append(fix)
        elif (
            not self._positions
            and message.get_type() == "HEARTBEAT"
            and now - self._asked > ASK_EVERY_SECONDS
        ):
            self._asked = now
            asked = mavlink.MAVLink_command_long_message(
                *(message.get_srcSystem(), message.get_srcComponent()),
                *(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, 0),
                *(mavlink.MAVLINK_MSG_ID_SIM_STATE, REPORT_MICROS, 0, 0, 0, 0, 0),
            )
            self._socket.sendto(asked.pack(self._encoder), sender)


class ArduCopter:
    """An ArduCopter process in a folder of its own; its second port goes to a ground truth receiver."""

    def __init__(self, folder: Path, server_port: int, system_id: int, home: str) -> None:
        """`home`: degrees, degrees, metres above the sea, heading."""
        binary = Path(str(BINARY))
        folder.mkdir(exist_ok=True)
        self.ground_truth = GroundTruthReceiver()
        with (folder / "sitl.log").open("wb") as log:
            self._process = subprocess.Popen(
                [
                    # Those of one instance number say that they are the same hardware.
                    *(str(binary), "-I", str(system_id), "--sysid", str(system_id)),
                    *("--wipe", "--model", "+", "--speedup", "1"),
                    *("--home", home, "--defaults", str(binary.parent / "copter.parm")),
                    *("--serial0", f"udpclient:127.0.0.1:{server_port}"),
                    *("--serial1", f"udpclient:127.0.0.1:{self.ground_truth.port}", "--serial2", "none"),
                    *("--rc-in-port", str(free_port(socket.SOCK_DGRAM))),
                ],
                cwd=folder,
                stdout=log,
                stderr=subprocess.STDOUT,
            )

    def kill(self) -> None:
        """At once and for good, wherever it is."""
        self._process.kill()
        self._process.wait()

    def close(self) -> None:
        self.kill()
        self.ground_truth.close()


def arms_and_enters_guided(api: Api, drone: str) -> bool:
    """A real one arms before it has a position; only armed it accepts or refuses GUIDED."""

    def succeeds(**body: str) -> bool:
        return bool(api.command(drone, dict(body))["outcome"]["result"] == "succeeded")

    guided = succeeds(type="arm") and succeeds(type="setMode", mode="GUIDED")
    api.command(drone, {"type": "disarm"})
    return guided
