"""The server killed with -9: vehicles hear it before its pages are there, and soon all is shown again."""

from pathlib import Path

from dronemap_e2e.api import Api
from dronemap_e2e.peer import Peer, with_hardware
from dronemap_e2e.server import Server
from dronemap_e2e.stopwatch import Stopwatch
from dronemap_e2e.waiting import wait_for

# So soon after a restart all is shown again.
RETURN_SECONDS = 15


def test_after_a_crash_vehicles_hear_the_server_before_its_pages_are_there(tmp_path: Path) -> None:
    """Pages take most of a start; ArduPilot flies home when it hears nothing for five seconds.

    End to end because it is about how long each part of a process takes to start.
    """
    own_server = Server(tmp_path / "data", as_shipped=True)
    own_server.start()
    api = Api(own_server.address, own_server.local_key())
    peer = Peer(own_server.udp_port, system_id=7, handlers={"COMMAND_LONG": with_hardware(0x5107)})
    wait_for("it is known", lambda: len(api.drones()) == 1)
    wait_for("it hears the server", lambda: peer.received("HEARTBEAT"))
    own_server.kill()
    peer.state.received.clear()

    watch = Stopwatch()
    own_server.begin()
    wait_for("it hears the server again", lambda: peer.received("HEARTBEAT"), 60)
    assert not own_server.is_up()
    wait_for("the pages are there", own_server.is_up, 60)
    again = Api(own_server.address, own_server.local_key())
    assert [drone["link"]["state"] for drone in again.drones()] == ["live"]
    watch.expect_at_most(RETURN_SECONDS)
    peer.close()
    own_server.stop()
