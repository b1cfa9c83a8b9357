"""Silence that is the server's own is nobody's loss."""

import os
import signal
from pathlib import Path

from dronemap_e2e.api import Api
from dronemap_e2e.peer import Peer
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import throughout, wait_for

STANDSTILL_SECONDS = 10


def paused(server: Server) -> bool:
    """True if the process is stopped, by its state in /proc."""
    return Path(f"/proc/{server.pid}/stat").read_text().rpartition(") ")[2].startswith("T")


def test_server_pause_does_not_mark_vehicles_lost(killable_server: Server) -> None:
    """End to end because only a process that is stopped stands still with all of its threads."""
    server = killable_server
    peers = [Peer(server.udp_port, system_id=220 + i) for i in range(4)]
    peers += [Peer(server.tcp_port, system_id=230, tcp=True)]
    try:
        api = Api(server.address, server.local_key())
        ports = {peer.port for peer in peers}

        def states() -> list[str]:
            return [d["link"]["state"] for d in api.drones() if d["link"]["port"] in ports]

        def all_live() -> bool:
            return states() == ["live"] * len(peers)

        wait_for("all are live", all_live, 30)
        os.kill(server.pid, signal.SIGSTOP)
        wait_for("the server stands still", lambda: paused(server), 10)
        # Ten seconds by the clock are the thing tested: twice the silence after which a drone is called lost.
        throughout("the server stands still", lambda: paused(server), STANDSTILL_SECONDS)
        os.kill(server.pid, signal.SIGCONT)

        def nobody_lost() -> bool:
            return "lost" not in states()

        throughout("nobody is called lost", nobody_lost, 8)
        texts = [m["text"] for d in api.drones() if d["link"]["port"] in ports for m in d["messages"]]
        assert "Contact lost." not in texts
        assert all_live()

        # The watchdog itself is still awake.
        peers[0].silent = True
        wait_for("the silent one is lost", lambda: "lost" in states(), 8)
        assert states().count("lost") == 1
    finally:
        for peer in peers:
            peer.close()
        os.kill(server.pid, signal.SIGCONT)
