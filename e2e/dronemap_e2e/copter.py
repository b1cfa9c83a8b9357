"""Copters of one system id with as many parameters as real ones have, each behind a message recorder."""

from collections.abc import Sequence
from pathlib import Path

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from .api import Api, Json
from .message_recorder import MessageRecorder
from .server import Server
from .simulator import QUICK_FLIGHT, Simulator
from .waiting import wait_for

PARAMETERS = 1_000

# Messages and commands that the cloud sends to vehicles by itself.
OWN_MESSAGES = {"HEARTBEAT", "TIMESYNC", "PING", "MISSION_REQUEST_LIST", "MISSION_REQUEST_INT", "MISSION_ACK"}
OWN_MESSAGES |= {"REQUEST_DATA_STREAM", "PARAM_REQUEST_READ"}
OWN_COMMANDS = {mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, mavlink.MAV_CMD_REQUEST_MESSAGE}


class Copter:
    """A copter of system id 1 behind a message recorder, as the server lists it."""

    def __init__(self, server: Server, api: Api, log: Path, hardware: int) -> None:
        self.recorder = MessageRecorder(server.udp_port)
        self.hardware = hardware
        before = {d["id"] for d in api.drones()}
        self._simulator = Simulator(
            log,
            f"udp://127.0.0.1:{self.recorder.port}",
            *("--sysid", "1", "--hardware", str(hardware)),
            *QUICK_FLIGHT,
            *("--parameters", str(PARAMETERS)),
        )

        def ready() -> Json | None:
            found = [
                d
                for d in api.drones()
                if d["id"] not in before and d["link"]["port"] in self.recorder.upstream_ports()
            ]
            fit = (
                found and found[0]["readyToArm"] and found[0]["home"] and found[0]["link"]["state"] == "live"
            )
            return found[0] if fit else None

        self.id = str(wait_for("the copter is ready", ready, 90)["id"])

    def close(self) -> None:
        self._simulator.stop()
        self.recorder.close()

    def messages_received(self) -> list[str]:
        """Messages to the vehicle, without those that the cloud sends by itself."""
        messages = [h.message for h in self.recorder.messages(up=False)]
        return [
            f"{m.get_type()} {getattr(m, 'command', '')}".strip()
            for m in messages
            if m.get_type() not in OWN_MESSAGES
            and not (m.get_type() in ("COMMAND_LONG", "COMMAND_INT") and m.command in OWN_COMMANDS)
        ]


def ids(copters: Sequence[Copter]) -> list[str]:
    return [copter.id for copter in copters]
