"""Free ports on loopback."""

import random
import socket

# Below those that systems give to whoever asks for any (from 32768 on): a server that is stopped and started
# again must find its port free.
LOWEST, HIGHEST = 20_000, 32_000


def free_port(kind: int = socket.SOCK_STREAM) -> int:
    while True:
        port = random.randint(LOWEST, HIGHEST)
        with socket.socket(socket.AF_INET, kind) as probe:
            try:
                probe.bind(("127.0.0.1", port))
            except OSError:
                continue
            return port
