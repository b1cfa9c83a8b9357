"""A tool and a server that pymavlink plays, on real sockets, with the relay between them."""

import socket
import threading
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from pymavlink.dialects.v20 import all as dialect

from dronemap_signing_relay.__main__ import arguments, passphrase, relay
from dronemap_signing_relay.addresses import Address, parse_address, parse_local_address

from .test_signing import PASSPHRASE, pymavlink_link

SECONDS = 10.0
Start = Callable[[list[str]], None]


def free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind(("127.0.0.1", 0))
        return int(sock.getsockname()[1])


def datagrams() -> socket.socket:
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    made.bind(("127.0.0.1", 0))
    made.settimeout(SECONDS)
    return made


def beat(sender: Any) -> bytes:
    return bytes(dialect.MAVLink_heartbeat_message(2, 3, 0, 0, 4, 3).pack(sender))


@pytest.fixture
def start() -> Iterator[Start]:
    """Runs a relay as the command line has it; ended afterwards."""
    ended = threading.Event()
    threads: list[threading.Thread] = []

    def begin(given: list[str]) -> None:
        made = relay(arguments(given), PASSPHRASE)
        threads.append(threading.Thread(target=made.run, args=(lambda: not ended.is_set(),)))
        threads[-1].start()

    yield begin
    ended.set()
    for thread in threads:
        thread.join(SECONDS)
        assert not thread.is_alive()


def test_sending_tool_is_signed_and_answered(start: Start) -> None:
    server, tool, port = datagrams(), datagrams(), free_port()
    start(["--server", f"udp:127.0.0.1:{server.getsockname()[1]}", "--listen", f"127.0.0.1:{port}"])
    with server, tool:
        tool.sendto(beat(pymavlink_link(system=245, passphrase=None)), ("127.0.0.1", port))
        data, relayed = server.recvfrom(600)
        (received,) = pymavlink_link().parse_buffer(data)
        assert received.get_signed()
        server.sendto(beat(pymavlink_link(passphrase="somebody else's")), relayed)
        server.sendto(beat(pymavlink_link(system=5)), relayed)
        (answer,) = pymavlink_link(passphrase=None).parse_buffer(tool.recv(600))
        assert (answer.get_srcSystem(), answer.get_signed()) == (5, False)


def test_listening_tool_gets_messages_first(start: Start) -> None:
    server, tool = datagrams(), datagrams()
    ports = [sock.getsockname()[1] for sock in (server, tool)]
    start(["--server", f"udp:127.0.0.1:{ports[0]}", "--to", f"127.0.0.1:{ports[1]}", "--system", "200"])
    with server, tool:
        data, relayed = server.recvfrom(600)
        (first,) = pymavlink_link().parse_buffer(data)
        assert (first.get_srcSystem(), first.get_type()) == (200, "HEARTBEAT")
        server.sendto(beat(pymavlink_link(system=5)), relayed)
        assert tool.recv(600)


def test_second_tool_is_ignored(start: Start) -> None:
    server, tool, other, port = datagrams(), datagrams(), datagrams(), free_port()
    start(["--server", f"udp:127.0.0.1:{server.getsockname()[1]}", "--listen", f"127.0.0.1:{port}"])
    with server, tool, other:
        tool.sendto(beat(pymavlink_link(system=201, passphrase=None)), ("127.0.0.1", port))
        server.recv(600)
        other.sendto(beat(pymavlink_link(system=202, passphrase=None)), ("127.0.0.1", port))
        tool.sendto(beat(pymavlink_link(system=203, passphrase=None)), ("127.0.0.1", port))
        reader, systems = pymavlink_link(), set[int]()
        while 203 not in systems:
            systems |= {m.get_srcSystem() for m in reader.parse_buffer(server.recv(600)) or []}
        assert 202 not in systems


def test_reconnect_discards_partial_frame(start: Start) -> None:
    tool = datagrams()
    with socket.create_server(("127.0.0.1", 0)) as listener, tool:
        listener.settimeout(SECONDS)
        port = listener.getsockname()[1]
        start(["--server", f"tcp:127.0.0.1:{port}", "--to", f"127.0.0.1:{tool.getsockname()[1]}"])
        first, _ = listener.accept()
        with first:
            first.sendall(beat(pymavlink_link(system=5))[:9])
        second, _ = listener.accept()
        with second:
            second.settimeout(SECONDS)
            second.sendall(beat(pymavlink_link(system=6)))
            (received,) = pymavlink_link(passphrase=None).parse_buffer(tool.recv(600))
            assert received.get_srcSystem() == 6
            assert second.recv(600)


@pytest.mark.parametrize(
    "text", ["0.0.0.0:14550", "192.0.2.1:14550", "tcp:127.0.0.1:14550", "127.0.0.1", ":5"]
)
def test_tool_address_is_loopback_only(text: str) -> None:
    with pytest.raises(ValueError):
        parse_local_address(text)


def test_addresses_are_parsed() -> None:
    assert parse_address("udp:drones.example:14560") == Address("drones.example", 14_560)
    assert parse_address("tcp:[::1]:5790") == Address("::1", 5_790, True)
    assert parse_local_address("localhost:14550") == Address("127.0.0.1", 14_550)
    assert str(parse_address("tcp:[::1]:5790")) == "tcp:[::1]:5790"


def test_passphrase_from_environment_or_prompt(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DRONEMAP_PASSPHRASE", PASSPHRASE)
    assert passphrase() == PASSPHRASE
    monkeypatch.delenv("DRONEMAP_PASSPHRASE")
    monkeypatch.setattr("getpass.getpass", lambda _: "asked for")
    assert passphrase() == "asked for"
    with pytest.raises(SystemExit):
        arguments(["--server", "udp:127.0.0.1:14560", "--passphrase", PASSPHRASE])
