"""Real ArduPilot vehicles in software, and a receiver of their true position; each needs its binary."""

import os
import socket
import subprocess
import threading
import time
from pathlib import Path
from typing import Any, NamedTuple

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from .api import Api
from .ports import free_port
from .runs import Track


class Firmware(NamedTuple):
    """One kind of ArduPilot: who names its binary, its model of physics, the defaults beside the binary."""

    vehicle: str
    setting: str
    model: str
    defaults: str

    @property
    def binary(self) -> str | None:
        return os.environ.get(self.setting)

    @property
    def why_not(self) -> str:
        return f"not proved: {self.setting} names no {self.vehicle} binary"


COPTER = Firmware("ArduCopter", "DRONEMAP_SITL_ARDUCOPTER", "+", "copter.parm")
PLANE = Firmware("ArduPlane", "DRONEMAP_SITL_ARDUPLANE", "plane", "plane.parm")
QUADPLANE = Firmware("ArduPlane", "DRONEMAP_SITL_ARDUPLANE", "quadplane", "quadplane.parm")
ROVER = Firmware("ArduRover", "DRONEMAP_SITL_ARDUROVER", "rover", "rover.parm")
RECEIVER_SYSTEM_ID = 200
ASK_EVERY_SECONDS = 2.0
REPORT_MICROS = 100_000
# A camera, of which ArduPilot has none by default.
PARAMETERS = "CAM1_TYPE 1\n"


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
        self._armed = False
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

    def armed(self) -> bool:
        """By the vehicle's own word, which the server does not hear."""
        return self._armed

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
        # It passes heartbeats of ground stations on.
        if message.get_type() == "HEARTBEAT" and message.autopilot != mavlink.MAV_AUTOPILOT_INVALID:
            self._armed = bool(message.base_mode & mavlink.MAV_MODE_FLAG_SAFETY_ARMED)
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


class Autopilot:
    """An autopilot process in a folder of its own; its second port goes to a ground truth receiver."""

    def __init__(
        self, firmware: Firmware, folder: Path, server_port: int, system_id: int, home: str, *more: str
    ) -> None:
        """`home`: degrees, degrees, metres above the sea, heading; `more`: arguments of the binary."""
        binary = Path(str(firmware.binary))
        folder.mkdir(exist_ok=True)
        own = folder / "own.parm"
        own.write_text(PARAMETERS)
        self.ground_truth = GroundTruthReceiver()
        with (folder / "sitl.log").open("wb") as log:
            self._process = subprocess.Popen(
                [
                    # Those of one instance number say that they are the same hardware.
                    *(str(binary), "-I", str(system_id), "--sysid", str(system_id)),
                    *("--wipe", "--model", firmware.model, "--speedup", "1"),
                    *("--home", home, "--defaults", f"{binary.parent / firmware.defaults},{own}"),
                    *("--serial0", f"udpclient:127.0.0.1:{server_port}"),
                    *("--serial1", f"udpclient:127.0.0.1:{self.ground_truth.port}", "--serial2", "none"),
                    *("--rc-in-port", str(free_port(socket.SOCK_DGRAM)), *more),
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
