"""A TCP proxy between a client and the server that can be cut: nothing passes, nothing is closed."""

import select
import socket
import threading
from contextlib import suppress


class CuttableProxy:
    """Carries TCP connections to one port of the server."""

    def __init__(self, server_port: int) -> None:
        self._server_port = server_port
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listener.getsockname()[1]
        self._other_end: dict[socket.socket, socket.socket] = {}
        self._cut = False
        self._closed = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def cut(self) -> None:
        self._cut = True

    def restore(self) -> None:
        """Passes data again; what was sent meanwhile arrives, as far as its sender still waits."""
        self._cut = False

    def close(self) -> None:
        self._closed = True
        self._thread.join()
        for end in [self._listener, *self._other_end]:
            end.close()

    def _run(self) -> None:
        while not self._closed:
            wanted = [] if self._cut else [self._listener, *self._other_end]
            for ready in select.select(wanted, [], [], 0.1)[0]:
                if ready is self._listener:
                    self._accept()
                elif ready in self._other_end and not self._cut:
                    self._forward(ready)

    def _accept(self) -> None:
        client, _ = self._listener.accept()
        server = socket.create_connection(("127.0.0.1", self._server_port))
        self._other_end |= {client: server, server: client}

    def _forward(self, sender: socket.socket) -> None:
        receiver = self._other_end[sender]
        data = b""
        with suppress(ConnectionError):
            data = sender.recv(65536)
            receiver.sendall(data)
        if not data:
            for end in (sender, receiver):
                del self._other_end[end]
                end.close()
