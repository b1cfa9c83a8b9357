"""The simulated copters of one worker: one process, of which each test wakes one that was silent before."""

from pathlib import Path

from .message_recorder import MessageRecorder, VehicleMessages
from .server import Server
from .simulator import QUICK_FLIGHT, Simulator

FIRST = 101
COUNT = 60
FOR_GOOD_SECONDS = 86_400


class Vehicles:
    """Copters five times as fast as life behind a message recorder, asleep until one is taken."""

    def __init__(self, server: Server, log: Path) -> None:
        self._recorder = MessageRecorder(server.udp_port)
        self._simulator = Simulator(
            log,
            f"udp://127.0.0.1:{self._recorder.port}",
            *("--count", str(COUNT), "--sysid", str(FIRST), "--asleep"),
            *QUICK_FLIGHT,
        )
        self._next = FIRST

    def wake_next(self) -> int:
        """Wakes the next one: its system id."""
        assert self._next < FIRST + COUNT, "too many tests take a copter: let the simulator have more"
        taken = self._next
        self._next += 1
        answer = self._simulator.send_command(f"wake {taken}")
        assert answer.startswith("ok"), answer
        return taken

    def silence(self, system_id: int) -> None:
        """Nobody needs that one any more."""
        self._simulator.fault(f"{system_id} silent {FOR_GOOD_SECONDS}s")

    def wire(self, system_id: int) -> VehicleMessages:
        return VehicleMessages(self._recorder, system_id)

    def fault(self, words: str) -> None:
        self._simulator.fault(words)

    def close(self) -> None:
        self._simulator.stop()
        self._recorder.close()
