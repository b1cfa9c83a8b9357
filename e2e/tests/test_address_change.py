"""Vehicles whose address changes all the time: none is lost, and no command goes to a wrong place."""

import secrets
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from typing import TypeVar

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api, Json
from dronemap_e2e.frame_links import Bridge, DtlsLink
from dronemap_e2e.nat import Nat
from dronemap_e2e.peer import STANDARD_HANDLERS, Handler, Peer, reporting_hardware
from dronemap_e2e.server import Server
from dronemap_e2e.signing_peer import SigningPeer
from dronemap_e2e.waiting import rounds, wait_for

from .conftest import SYSTEM_IDS

P = TypeVar("P", bound=Peer)
ARM = mavlink.MAV_CMD_COMPONENT_ARM_DISARM
HOME, ELSEWHERE = 473977420, 100000000
# So long may it take until nobody speaks to an address that was left: a proof is believed at once and the
# old link is given up when it is silent for a second; without proof it takes 1.5 s of silence and a claim.
# The rest is room for a busy machine.
LATEST_WITH_PROOF = 4.0
LATEST_WITHOUT_PROOF = 6.0
# These hold no order: who is there, who are you, how long is the way.
HARMLESS = {"HEARTBEAT", "TIMESYNC"}
QUESTIONS = {mavlink.MAV_CMD_REQUEST_MESSAGE, mavlink.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES}


@dataclass
class MovingVehicle:
    """A vehicle whose address changes, its hardware id, and its drone at the server."""

    peer: Peer
    uid: int
    drone: str
    commanded: int = 0

    @property
    def system_id(self) -> int:
        system_id: int = self.peer.link.srcSystem
        return system_id


def new_uid() -> int:
    return secrets.randbits(63) | 1


def handlers(uid: int) -> dict[str, Handler]:
    return {**STANDARD_HANDLERS, "COMMAND_LONG": reporting_hardware(uid)}


def live_drone(api: Api, system_id: int) -> Json:
    def find() -> Json | None:
        found = [d for d in api.drones() if d["link"]["systemId"] == system_id]
        return found[0] if found and found[0]["link"]["state"] == "live" else None

    return wait_for("the vehicle is listed", find, 30)


def require_signing(api: Api, peer: SigningPeer, policy: str) -> str:
    """The drone of a vehicle that signs from now on."""
    drone: str = live_drone(api, peer.link.srcSystem)["id"]
    assert api.call("POST", f"/drones/{drone}/link-key", {}).status_code == 201
    answer = api.call("POST", f"/drones/{drone}/link-key/install")
    assert answer.status_code == 200 and answer.json()["key"]["inUse"], answer.text
    assert api.call("PUT", f"/drones/{drone}/link-security", {"policy": policy}).status_code == 200
    return drone


@contextmanager
def dtls_endpoint(api: Api) -> Iterator[int]:
    answer = api.call("POST", "/endpoints", {"url": "dtlsserver://127.0.0.1:0"})
    assert answer.status_code == 201, answer.text
    path = f"/endpoints/{answer.json()['id']}"
    try:
        wait_for("it is open", lambda: api.get(path)["state"] == "open", 20)
        yield int(api.get(path)["url"].rsplit(":", 1)[1])
    finally:
        assert api.call("DELETE", path).status_code == 204


class Forger:
    """Imitates a vehicle: the same system id, the same hardware, at another place."""

    def __init__(self, server: Server, imitated: MovingVehicle) -> None:
        self.peer = Peer(server.udp_port, system_id=imitated.system_id, handlers=handlers(imitated.uid))
        self._uid = imitated.uid
        self._left: list[Peer.FormerAddress] = []

    def send_false_messages(self) -> None:
        none = bytes(8)
        self.peer.link.autopilot_version_send(0, 0, 0, 0, 0, none, none, none, 0, 0, self._uid)
        self.peer.link.global_position_int_send(0, ELSEWHERE, ELSEWHERE, 498000, 10000, 0, 0, 0, 0)

    def move(self) -> None:
        self._left.append(self.peer.move())

    def close(self) -> None:
        self.peer.close()
        for place in self._left:
            place.close()


class AddressChanges:
    """Signed and DTLS vehicles behind NATs that forget fast, unsigned ones behind a slow one."""

    def __init__(self, server: Server, api: Api, stack: ExitStack) -> None:
        self._api = api
        self._server = server
        self._stack = stack
        self.fast = self._nat(server.udp_port)
        self.fast_dtls = self._nat(stack.enter_context(dtls_endpoint(api)))
        self.slow = self._nat(server.udp_port)
        self.signed = [self._signing_vehicle(policy) for policy in ("required", "optional")]
        self.encrypted = self._dtls_vehicle()
        self.unsigned = [self._unsigned_vehicle() for _ in range(2)]
        # Nobody commands this one, which changes its address all the same.
        self.bystander = self._unsigned_vehicle()
        self.all = [*self.signed, self.encrypted, *self.unsigned, self.bystander]

    def _nat(self, server_port: int) -> Nat:
        nat = Nat(server_port, seconds=3600)
        self._stack.callback(nat.close)
        return nat

    def _signing_vehicle(self, policy: str) -> MovingVehicle:
        uid = new_uid()
        peer = SigningPeer(self.fast.port, next(SYSTEM_IDS), handlers=handlers(uid))
        return self._as_vehicle(peer, uid, require_signing(self._api, self._closed_at_end(peer), policy))

    def _unsigned_vehicle(self) -> MovingVehicle:
        uid = new_uid()
        peer = self._closed_at_end(Peer(self.slow.port, system_id=next(SYSTEM_IDS), handlers=handlers(uid)))
        return self._as_vehicle(peer, uid, live_drone(self._api, peer.link.srcSystem)["id"])

    def _dtls_vehicle(self) -> MovingVehicle:
        key = self._api.call("POST", "/dtls-keys", {"label": "travelling copter"}).json()
        bridge = Bridge(DtlsLink(self.fast_dtls.port, key["identity"], key["secret"]))
        self._stack.callback(bridge.close)
        uid = new_uid()
        peer = self._closed_at_end(Peer(bridge.port, system_id=next(SYSTEM_IDS), handlers=handlers(uid)))
        return self._as_vehicle(peer, uid, live_drone(self._api, peer.link.srcSystem)["id"])

    def _closed_at_end(self, peer: P) -> P:
        """Closes it when the journey is over."""
        self._stack.callback(peer.close)
        return peer

    def _as_vehicle(self, peer: Peer, uid: int, drone: str) -> MovingVehicle:
        wait_for("its hardware is known", lambda: self._api.drone(drone)["identity"]["hardwareId"], 30)
        return MovingVehicle(peer, uid, drone)

    def start_changes(self) -> None:
        self.fast.seconds = self.fast_dtls.seconds = 2
        self.slow.seconds = 10

    def command(self, one: MovingVehicle, until: float) -> None:
        """Arms and disarms it again and again; asserts that it does so each time."""
        api = Api(self._server.address, self._server.local_key())
        arm = True
        for _ in rounds(until, 0.2):
            record = api.command(one.drone, {"type": "arm" if arm else "disarm"})
            assert record["outcome"]["result"] == "succeeded", record
            assert one.peer.state.armed is arm
            one.commanded += 1
            arm = not arm

    def watch(self, until: float) -> None:
        """Nobody is lost, doubled or moved by a forger."""
        for _ in rounds(until, 0.2):
            drones = self._api.drones()
            for one in self.all:
                mine = [d for d in drones if d["link"]["systemId"] == one.system_id]
                assert [d["id"] for d in mine] == [one.drone]
                assert mine[0]["link"]["state"] != "lost"
                position = mine[0]["position"]
                assert position is None or abs(position["latitude"] - HOME / 1e7) < 1e-6, mine[0]
                one.peer.link.global_position_int_send(0, HOME, HOME, 498000, 10000, 0, 0, 0, 0)


def orders(nat: Nat, latest: float) -> list[str]:
    """Orders that came to an address so long after it was left."""
    parser = mavlink.MAVLink(None)
    parser.robust_parsing = True
    found = []
    for seconds, data in list(nat.late):
        for message in parser.parse_buffer(data) or []:
            kind = message.get_type()
            question = kind == "COMMAND_LONG" and message.command in QUESTIONS
            if seconds > latest and kind not in HARMLESS and not question:
                found.append(f"{seconds:.1f} s after: {message}")
    return found


def change_addresses(server: Server, api: Api, seconds: float) -> None:
    with ExitStack() as stack:
        changes_of_address = AddressChanges(server, api, stack)
        # The forger of an unproved vehicle stays where it is; against one that moves too, only proof helps.
        still = Forger(server, changes_of_address.unsigned[0])
        stack.callback(still.close)
        moving = [
            Forger(server, imitated)
            for imitated in (changes_of_address.signed[0], changes_of_address.encrypted)
        ]
        for forger in moving:
            stack.callback(forger.close)
        changes_of_address.start_changes()
        until = time.monotonic() + seconds
        stop = threading.Event()

        def send_forged() -> None:
            next_move = time.monotonic() + 1.7
            while not stop.is_set():
                for forger in (still, *moving):
                    forger.send_false_messages()
                if time.monotonic() > next_move:
                    next_move += 1.7
                    for forger in moving:
                        forger.move()
                stop.wait(0.2)

        commanded = [one for one in changes_of_address.all if one is not changes_of_address.bystander]
        with ThreadPoolExecutor(len(commanded) + 2) as pool:
            forged = pool.submit(send_forged)
            work = [pool.submit(changes_of_address.command, one, until) for one in commanded]
            try:
                changes_of_address.watch(until)
                for job in work:
                    job.result()
            finally:
                stop.set()
            forged.result()
        check_and_print(changes_of_address, [still, *moving])


def check_and_print(changes_of_address: AddressChanges, forgers: list[Forger]) -> None:
    changes = {
        "fast": changes_of_address.fast.changes,
        "dtls": changes_of_address.fast_dtls.changes,
        "slow": changes_of_address.slow.changes,
    }
    print("changes of address:", changes, "commands:", [one.commanded for one in changes_of_address.all])
    assert changes["fast"] >= 2 * len(changes_of_address.signed) and changes["slow"] >= 2, changes
    assert orders(changes_of_address.fast, LATEST_WITH_PROOF) == []
    assert orders(changes_of_address.slow, LATEST_WITHOUT_PROOF) == []
    assert [
        (when, data[:16]) for when, data in changes_of_address.fast_dtls.late if when > LATEST_WITH_PROOF
    ] == []
    assert changes_of_address.bystander.peer.commands(ARM) == []
    for forger in forgers:
        assert forger.peer.commands(ARM) == []
    for one in changes_of_address.all:
        own = [m for m in one.peer.commands(ARM) if m.target_system != one.system_id]
        assert own == [] and (one.commanded >= 3 or one is changes_of_address.bystander)


@pytest.mark.soak
def test_vehicles_keep_their_drones_while_addresses_change(server: Server, api: Api) -> None:
    change_addresses(server, api, seconds=120)
