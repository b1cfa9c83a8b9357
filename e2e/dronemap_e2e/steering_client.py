"""A client that steers one drone over the stream."""

import json
import threading

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from .server import Server


class SteeringClient:
    """Steers as the page does, ten times a second; once cut, it sends nothing and closes nothing."""

    def __init__(
        self,
        server: Server,
        key: str | None,
        drone: str,
        forward: float = 0.4,
        by: str = "velocity",
        ticket: str = "",
    ) -> None:
        """`by`: velocity or sticks; without a key, `ticket` is one of a session."""
        headers = {"Authorization": f"Bearer {key}"} if key else {}
        address = server.stream_address + (f"?ticket={ticket}" if ticket else "")
        self._stream: ClientConnection = connect(address, additional_headers=headers)
        self._setpoint = json.dumps({"type": "steer", "drone": drone, by: {"forward": forward}})
        self._cut = threading.Event()
        self._thread = threading.Thread(target=self._steer, daemon=True)
        self._thread.start()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        """Without a reader the stream is called too slow and closed."""
        try:
            for _ in self._stream:
                pass
        except (ConnectionClosed, OSError):
            return

    def _steer(self) -> None:
        try:
            while not self._cut.wait(0.1):
                self._stream.send(self._setpoint)
        except (ConnectionClosed, OSError):
            # The server has gone.
            return

    def cut(self) -> None:
        self._cut.set()
        self._thread.join()

    def kill(self) -> None:
        """Ends as a killed program does: its connection breaks without a close."""
        self.cut()
        self._stream.socket.close()

    def close(self) -> None:
        self.cut()
        self._stream.close()
