"""A bad link: a UDP relay that delays, loses, doubles and reorders, the same way for the same seed."""

import heapq
import itertools
import random
import selectors
import socket
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

LOOPBACK = "127.0.0.1"


@dataclass(frozen=True)
class LinkConditions:
    """Impairments of a link, in each direction. Datagrams overtake each other as their delays differ."""

    delay: float = 0.0
    jitter: float = 0.0
    loss: float = 0.0
    duplication: float = 0.0


UNIMPAIRED = LinkConditions()
CUT = LinkConditions(loss=1.0)
BAD = LinkConditions(delay=0.5, jitter=0.2, loss=0.1, duplication=0.02)


class Impairer:
    """Stands between vehicles, which call `port`, and a server, which sees one port for each vehicle."""

    def __init__(self, server_port: int, seed: int = 1, conditions: LinkConditions = UNIMPAIRED) -> None:
        self.conditions = conditions
        self.forwarded = 0
        self.lost = 0
        # Called with every datagram of every vehicle before it is impaired.
        self.on_datagram: Callable[[bytes], None] = lambda data: None
        # True for datagrams of vehicles that never arrive, however good the link is.
        self.drops: Callable[[bytes], bool] = lambda data: False
        self._server = (LOOPBACK, server_port)
        self._random = random.Random(seed)
        self._front = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._front.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
        self._front.bind((LOOPBACK, 0))
        self.port: int = self._front.getsockname()[1]
        self._backs: dict[tuple[str, int], socket.socket] = {}
        self._due: list[tuple[float, int, socket.socket, tuple[str, int], bytes]] = []
        self._order = itertools.count()
        self._selector = selectors.DefaultSelector()
        self._selector.register(self._front, selectors.EVENT_READ, None)
        self._closed = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def server_side_port(self, vehicle_port: int) -> int:
        """The port that the server knows a vehicle by."""
        port: int = self._backs[(LOOPBACK, vehicle_port)].getsockname()[1]
        return port

    def send_to_vehicles(self, data: bytes) -> None:
        """Straight to every vehicle, as somebody who is plugged in there."""
        for vehicle in list(self._backs):
            self._front.sendto(data, vehicle)

    def close(self) -> None:
        self._closed = True
        self._thread.join()
        for back in self._backs.values():
            back.close()
        self._front.close()
        self._selector.close()

    def _run(self) -> None:
        while not self._closed:
            pause = max(0.0, self._due[0][0] - time.monotonic()) if self._due else 0.05
            for key, _ in self._selector.select(min(pause, 0.05)):
                self._read(key.fileobj, key.data)
            self._deliver()

    def _read(self, source: object, vehicle: tuple[str, int] | None) -> None:
        assert isinstance(source, socket.socket)
        try:
            data, sender = source.recvfrom(65535)
        except ConnectionError:
            return
        if vehicle is None:
            self.on_datagram(data)
            if not self.drops(data):
                self._forward(self._back(sender), self._server, data)
        else:
            self._forward(self._front, vehicle, data)

    def _back(self, vehicle: tuple[str, int]) -> socket.socket:
        if vehicle not in self._backs:
            back = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            back.bind((LOOPBACK, 0))
            self._backs[vehicle] = back
            self._selector.register(back, selectors.EVENT_READ, vehicle)
        return self._backs[vehicle]

    def _forward(self, way: socket.socket, to: tuple[str, int], data: bytes) -> None:
        conditions = self.conditions
        if self._random.random() < conditions.loss:
            self.lost += 1
            return
        copies = 2 if self._random.random() < conditions.duplication else 1
        for _ in range(copies):
            delay = conditions.delay + self._random.uniform(-conditions.jitter, conditions.jitter)
            heapq.heappush(self._due, (time.monotonic() + delay, next(self._order), way, to, data))

    def newest(self) -> int:
        """Stands for all that is on its way now; for `arrived`."""
        return next(self._order)

    def arrived(self, newest: int) -> bool:
        """Nothing that was on its way then still is."""
        return all(order > newest for _, order, *_ in list(self._due))

    def _deliver(self) -> None:
        now = time.monotonic()
        while self._due and self._due[0][0] <= now:
            _, _, way, to, data = heapq.heappop(self._due)
            self.forwarded += 1
            try:
                way.sendto(data, to)
            except ConnectionError:
                continue
