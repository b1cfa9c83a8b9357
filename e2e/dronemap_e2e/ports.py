"""Free ports on loopback."""

import os
import random
import socket

# Below those that systems give to whoever asks for any (from 32768 on): a server that is stopped and started
# again must find its port free.
LOWEST, HIGHEST = 20_000, 32_000
# Of several processes that test at once each takes ports of its own.
WORKERS = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
WORKER = int(os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw"))

_given: set[int] = set()


def own_host() -> str:
    """A loopback address for one test: there even ports that others want as well are free."""
    return f"127.{random.randrange(1, 255)}.{random.randrange(256)}.{random.randrange(1, 255)}"


def free_port(kind: int = socket.SOCK_STREAM) -> int:
    """None that was given out before: whoever got it may not listen there yet, or not at the moment."""
    while True:
        port = random.randrange(LOWEST + WORKER, HIGHEST, WORKERS)
        if port in _given:
            continue
        with socket.socket(socket.AF_INET, kind) as probe:
            try:
                probe.bind(("127.0.0.1", port))
            except OSError:
                continue
        _given.add(port)
        return port
