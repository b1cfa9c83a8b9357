"""A client that takes control of a drone and keeps it until it is killed: run as a program of its own."""

import sys
import time

from .api import Api

HEARTBEAT_SECONDS = 2.0


def main(address: str, key: str, drone: str) -> None:
    api = Api(address, key)
    taken = api.call("POST", f"/drones/{drone}/control/take", {})
    assert taken.status_code == 200, taken.text
    epoch = taken.json()["epoch"]
    print("taken", flush=True)
    while True:
        time.sleep(HEARTBEAT_SECONDS)
        answer = api.call("POST", f"/drones/{drone}/control/heartbeat", {"epoch": epoch})
        assert answer.status_code == 200, answer.text


if __name__ == "__main__":
    main(*sys.argv[1:])
