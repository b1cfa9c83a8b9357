"""Addresses as they are written on the command line."""

import ipaddress
from typing import NamedTuple


class Address(NamedTuple):
    """A host and a port; `stream`: by TCP."""

    host: str
    port: int
    stream: bool = False

    def __str__(self) -> str:
        host = f"[{self.host}]" if ":" in self.host else self.host
        return f"{'tcp' if self.stream else 'udp'}:{host}:{self.port}"


def parse_address(text: str) -> Address:
    """HOST:PORT or [HOST]:PORT, after an optional udp: or tcp:."""
    kind, colon, rest = text.partition(":")
    if kind not in ("udp", "tcp") or not colon:
        kind, rest = "udp", text
    host, _, port = rest.rpartition(":")
    host = host.removeprefix("[").removesuffix("]")
    if not host or not port.isdecimal() or not 0 < int(port) < 65_536:
        raise ValueError(f"{text} is no address; write udp:HOST:PORT or tcp:HOST:PORT")
    return Address(host, int(port), kind == "tcp")


def parse_local_address(text: str) -> Address:
    """An address of this machine alone: whoever reaches the tool's side acts in the name of the user."""
    address = parse_address(text)
    if address.stream:
        raise ValueError(f"{text}: tools are spoken to by udp")
    try:
        own = ipaddress.ip_address(address.host).is_loopback
    except ValueError:
        own = address.host == "localhost"
    if not own:
        raise ValueError(
            f"{text} is not only this machine's: whoever reached it would act in your name; use 127.0.0.1"
        )
    return address._replace(host="127.0.0.1") if address.host == "localhost" else address
