"""A WebSocket to a cloud, kept up by threads of its own: who sends or takes never waits for the network."""

import queue
import threading
from typing import Any, List, Optional

#: A robot says about ten messages a second; more than that many only wait where the network does.
MOST_WAITING = 32
PATIENCE_SECONDS = 10
LARGEST_ORDER = 65_535


class WebSocketLink:
    """Connects again after one second, then two, and so on up to ten. Needs the package ``websockets``."""

    def __init__(self, address: str) -> None:
        from websockets.exceptions import WebSocketException
        from websockets.sync.client import connect

        self._connect: Any = connect
        self._failures = (OSError, WebSocketException)
        self._address = address
        self._received: "queue.Queue[str]" = queue.Queue(MOST_WAITING)
        self._out: "queue.Queue[Optional[str]]" = queue.Queue(MOST_WAITING)
        self._ended = threading.Event()
        self._up = threading.Event()
        #: What the network had no room for.
        self.dropped = 0
        threading.Thread(target=self._keep_connected, name="web", daemon=True).start()

    def send(self, text: str) -> bool:
        """False while there is no connection."""
        if not self._up.is_set():
            return False
        try:
            self._out.put_nowait(text)
        except queue.Full:
            self.dropped += 1
        return True

    def receive(self) -> List[str]:
        """The texts received since the last call."""
        taken = []
        while not self._received.empty():
            taken.append(self._received.get_nowait())
        return taken

    def close(self) -> None:
        self._ended.set()
        self._up.clear()

    def _keep_connected(self) -> None:
        tries = 0
        while not self._ended.is_set():
            try:
                with self._connect(
                    self._address, open_timeout=PATIENCE_SECONDS, close_timeout=1, max_size=LARGEST_ORDER
                ) as connection:
                    tries = 1
                    self._exchange(connection)
            except self._failures:
                # Nobody is there just now; UDP carries on meanwhile.
                tries = min(tries + 1, PATIENCE_SECONDS)
            self._up.clear()
            self._ended.wait(tries)

    def _exchange(self, connection: Any) -> None:
        # What was said before is old.
        while not self._out.empty():
            self._out.get_nowait()
        listener = threading.Thread(target=self._receive, args=(connection,), name="web-in", daemon=True)
        self._up.set()
        listener.start()
        while listener.is_alive() and not self._ended.is_set():
            try:
                text = self._out.get(timeout=0.1)
            except queue.Empty:
                continue
            connection.send(text)

    def _receive(self, connection: Any) -> None:
        try:
            for text in connection:
                # With no room the newest is left out, as on any link: the next second says it again.
                self._received.put(str(text), timeout=PATIENCE_SECONDS)
        except self._failures + (queue.Full,):
            # The one who sends ends the connection and begins a new one.
            return
        finally:
            self._up.clear()
