"""A thousand simulated vehicles in one process, four times a second each, on half a core."""

import os
import socket
import struct
import time
from collections import Counter
from pathlib import Path

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.simulator import Simulator

VEHICLES = 1_000
HERTZ = 4
MEASURED_SECONDS = 20
MOST_CORES = 0.5
HEARTBEAT = 0
GLOBAL_POSITION_INT = 33
Address = tuple[str, int]


class GroundStation:
    """A ground station that asks every vehicle for its position and only counts what comes."""

    def __init__(self) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4_000_000)
        self._socket.bind(("127.0.0.1", 0))
        self._socket.settimeout(0.5)
        self._writer = mavlink.MAVLink(None, srcSystem=255, srcComponent=190)
        self.port: int = self._socket.getsockname()[1]
        self.positions: Counter[Address] = Counter()

    def listen(self, seconds: float) -> None:
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            try:
                datagram, sender = self._socket.recvfrom(65_535)
            except TimeoutError:
                continue
            for message, system in messages(datagram):
                self.positions[sender] += message == GLOBAL_POSITION_INT
                # Asked again until it comes: nobody promises that a datagram arrives.
                if message == HEARTBEAT and not self.positions[sender]:
                    self._ask(sender, system)

    def close(self) -> None:
        self._socket.close()

    def _ask(self, vehicle: Address, system: int) -> None:
        interval = (mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, 0, GLOBAL_POSITION_INT, 1e6 / HERTZ, 0, 0, 0, 0, 0)
        command = mavlink.MAVLink_command_long_message(system, 1, *interval)
        self._socket.sendto(command.pack(self._writer), vehicle)


def messages(datagram: bytes) -> list[tuple[int, int]]:
    """Message and system ids of the MAVLink 2 frames in a datagram; a vehicle boots with plain text."""
    found, at = [], 0
    while at < len(datagram) and datagram[at] == mavlink.PROTOCOL_MARKER_V2:
        length, _, _, _, system = struct.unpack_from("<BBBBB", datagram, at + 1)
        found.append((int.from_bytes(datagram[at + 7 : at + 10], "little"), system))
        at += 12 + length
    return found


def processor_seconds(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(") ", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@pytest.mark.soak
def test_thousand_simulated_vehicles_need_half_a_core(tmp_path: Path) -> None:
    ground = GroundStation()
    address = f"udp://127.0.0.1:{ground.port}"
    simulator = Simulator(tmp_path / "sim.log", address, "--count", str(VEHICLES), as_shipped=True)
    try:
        deadline = time.monotonic() + 90
        while sum(count > 0 for count in ground.positions.values()) < VEHICLES:
            assert time.monotonic() < deadline, f"{len(ground.positions)} vehicles were heard"
            ground.listen(1)
        # What the virtual machine compiles at the start is no part of flying.
        ground.listen(10)
        ground.positions.clear()
        before, began = processor_seconds(simulator.pid), time.monotonic()
        ground.listen(MEASURED_SECONDS)
        used, took = processor_seconds(simulator.pid) - before, time.monotonic() - began
    finally:
        simulator.stop()
        ground.close()

    assert len(ground.positions) == VEHICLES
    assert min(ground.positions.values()) >= 0.9 * HERTZ * took, "the slowest one is late"
    assert used <= MOST_CORES * took, f"{used / took:.2f} of a core"
