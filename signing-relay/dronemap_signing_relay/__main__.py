"""python -m dronemap_signing_relay: attaches a tool that cannot sign."""

import argparse
import getpass
import logging
import os
import socket
import sys
from collections.abc import Callable, Sequence

from .addresses import Address, parse_address, parse_local_address
from .bridge import Bridge
from .relay import Relay
from .signing import Signing

VARIABLE = "DRONEMAP_PASSPHRASE"
DEFAULT_SYSTEM = 245


def _argument_type(parse: Callable[[str], Address]) -> Callable[[str], Address]:
    def of(text: str) -> Address:
        try:
            return parse(text)
        except ValueError as e:
            raise argparse.ArgumentTypeError(str(e)) from e

    return of


def _number(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= 255:
        raise argparse.ArgumentTypeError("a number from 1 to 255")
    return int(text)


def arguments(given: Sequence[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="dronemap_signing_relay",
        description="Attaches a tool that cannot sign to the outlet of a Dronemap server: signs what the tool"
        " says, and checks what the server has signed."
        f" The passphrase is asked for, or taken from {VARIABLE}.",
    )
    parser.add_argument(
        "--server", type=_argument_type(parse_address), required=True, metavar="udp:HOST:14560|tcp:HOST:5790"
    )
    side = parser.add_mutually_exclusive_group()
    side.add_argument(
        "--listen",
        type=_argument_type(parse_local_address),
        metavar="127.0.0.1:PORT",
        help="the tool sends there (usual: 127.0.0.1:14550)",
    )
    side.add_argument(
        "--to",
        type=_argument_type(parse_local_address),
        metavar="127.0.0.1:PORT",
        help="the tool listens there and is sent to",
    )
    parser.add_argument(
        "--system",
        type=_number,
        metavar="ID",
        help="the system id that the tool calls itself, where it is wanted before the tool has spoken"
        f" (usual: the tool's; with --to {DEFAULT_SYSTEM}, as MAVSDK has it)",
    )
    parser.add_argument(
        "--link",
        type=_number,
        default=1,
        metavar="ID",
        help="another one for each that runs at once (usual: 1)",
    )
    return parser.parse_args(given)


def passphrase() -> str:
    """Never from the command line, which everybody on the machine can read."""
    known = os.environ.get(VARIABLE)
    return known if known else getpass.getpass("Passphrase of the outlet: ")


def relay(options: argparse.Namespace, secret: str) -> Relay:
    """Ready to run; the tool's side is open.

    Raises OSError when that port is taken."""
    address: Address = options.to or options.listen or Address("127.0.0.1", 14_550)
    system = options.system or (DEFAULT_SYSTEM if options.to else None)
    signing = Signing(secret, options.link)
    bridge = Bridge(signing, system, options.server.stream)
    tool = socket.socket(socket.AF_INET6 if ":" in address.host else socket.AF_INET, socket.SOCK_DGRAM)
    try:
        tool.bind((address.host, 0 if options.to else address.port))
    except OSError:
        tool.close()
        raise
    opened = Relay(bridge, signing, options.server, tool)
    if options.to:
        opened.send_to((address.host, address.port))
    return opened


def main() -> int:
    options = arguments()
    logging.basicConfig(level=logging.INFO, format="%(message)s", stream=sys.stderr)
    secret = passphrase()
    if not secret:
        print("Without a passphrase nothing can be signed.", file=sys.stderr)
        return 2
    try:
        relay(options, secret).run()
    except OSError as e:
        print(f"The tool's side cannot be opened: {e}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
