"""Checks that drops of the kernel are counted: a measurement that cannot see them would find none."""

import socket

from dronemap_bench import machine


def test_kernel_drops_are_counted() -> None:
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as full,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender,
    ):
        full.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        full.bind(("127.0.0.1", 0))
        port = full.getsockname()[1]
        assert machine.kernel_drops(port) == 0
        for _ in range(200):
            sender.sendto(bytes(1000), ("127.0.0.1", port))
        assert machine.kernel_drops(port) > 100
