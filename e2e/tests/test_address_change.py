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
class Traveller:
    """A vehicle on the move, its hardware id, and the drone that the server made of it."""

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


def the_drone(api: Api, system_id: int) -> Json:
    def find() -> Json | None:
        found = [d for d in api.drones() if d["link"]["systemId"] == system_id]
        return found[0] if found and found[0]["link"]["state"] == "live" else None

    return wait_for("the vehicle is listed", find, 30)


def secured(api: Api, peer: SigningPeer, policy: str) -> str:
    """The drone of a vehicle that signs from now on."""
    drone: str = the_drone(api, peer.link.srcSystem)["id"]
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
    """Says that it is that vehicle: the same system id, the same hardware, at another place."""

    def __init__(self, server: Server, victim: Traveller) -> None:
        self.peer = Peer(server.udp_port, system_id=victim.system_id, handlers=handlers(victim.uid))
        self._uid = victim.uid
        self._left: list[Peer.Forwarding] = []

    def lie(self) -> None:
        none = bytes(8)
        self.peer.link.autopilot_version_send(0, 0, 0, 0, 0, none, none, none, 0, 0, self._uid)
        self.peer.link.global_position_int_send(0, ELSEWHERE, ELSEWHERE, 498000, 10000, 0, 0, 0, 0)

    def move(self) -> None:
        self._left.append(self.peer.move())

    def close(self) -> None:
        self.peer.close()
        for place in self._left:
            place.close()


class Journey:
    """Signed and DTLS vehicles behind NATs that forget fast, unsigned ones behind a slow one."""

    def __init__(self, server: Server, api: Api, stack: ExitStack) -> None:
        self._api = api
        self._server = server
        self._stack = stack
        self.fast = self._nat(server.udp_port)
        self.fast_dtls = self._nat(stack.enter_context(dtls_endpoint(api)))
        self.slow = self._nat(server.udp_port)
        self.signed = [self._signing(policy) for policy in ("required", "optional")]
        self.encrypted = self._by_dtls()
        self.unproved = [self._unproved() for _ in range(2)]
        # Nobody commands this one, which changes its address all the same.
        self.bystander = self._unproved()
        self.all = [*self.signed, self.encrypted, *self.unproved, self.bystander]

    def _nat(self, server_port: int) -> Nat:
        nat = Nat(server_port, seconds=3600)
        self._stack.callback(nat.close)
        return nat

    def _signing(self, policy: str) -> Traveller:
        uid = new_uid()
        peer = SigningPeer(self.fast.port, next(SYSTEM_IDS), handlers=handlers(uid))
        return self._known(peer, uid, secured(self._api, self._closed(peer), policy))

    def _unproved(self) -> Traveller:
        uid = new_uid()
        peer = self._closed(Peer(self.slow.port, system_id=next(SYSTEM_IDS), handlers=handlers(uid)))
        return self._known(peer, uid, the_drone(self._api, peer.link.srcSystem)["id"])

    def _by_dtls(self) -> Traveller:
        key = self._api.call("POST", "/dtls-keys", {"label": "travelling copter"}).json()
        bridge = Bridge(DtlsLink(self.fast_dtls.port, key["identity"], key["secret"]))
        self._stack.callback(bridge.close)
        uid = new_uid()
        peer = self._closed(Peer(bridge.port, system_id=next(SYSTEM_IDS), handlers=handlers(uid)))
        return self._known(peer, uid, the_drone(self._api, peer.link.srcSystem)["id"])

    def _closed(self, peer: P) -> P:
        """Closes it when the journey is over."""
        self._stack.callback(peer.close)
        return peer

    def _known(self, peer: Peer, uid: int, drone: str) -> Traveller:
        wait_for("its hardware is known", lambda: self._api.drone(drone)["identity"]["hardwareId"], 30)
        return Traveller(peer, uid, drone)

    def begin(self) -> None:
        self.fast.seconds = self.fast_dtls.seconds = 2
        self.slow.seconds = 10

    def command(self, one: Traveller, until: float) -> None:
        """Arms and disarms it again and again; each time it does what it was told."""
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
    """What tells a vehicle to do something and came to an address so long after it was left."""
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


def travel(server: Server, api: Api, seconds: float) -> None:
    with ExitStack() as stack:
        journey = Journey(server, api, stack)
        # The forger of an unproved vehicle stays where it is; against one that moves too, only proof helps.
        still = Forger(server, journey.unproved[0])
        stack.callback(still.close)
        moving = [Forger(server, victim) for victim in (journey.signed[0], journey.encrypted)]
        for forger in moving:
            stack.callback(forger.close)
        journey.begin()
        until = time.monotonic() + seconds
        stop = threading.Event()

        def forge() -> None:
            next_move = time.monotonic() + 1.7
            while not stop.is_set():
                for forger in (still, *moving):
                    forger.lie()
                if time.monotonic() > next_move:
                    next_move += 1.7
                    for forger in moving:
                        forger.move()
                stop.wait(0.2)

        commanded = [one for one in journey.all if one is not journey.bystander]
        with ThreadPoolExecutor(len(commanded) + 2) as pool:
            lies = pool.submit(forge)
            work = [pool.submit(journey.command, one, until) for one in commanded]
            try:
                journey.watch(until)
                for job in work:
                    job.result()
            finally:
                stop.set()
            lies.result()
        told(journey, [still, *moving])


def told(journey: Journey, forgers: list[Forger]) -> None:
    changes = {"fast": journey.fast.changes, "dtls": journey.fast_dtls.changes, "slow": journey.slow.changes}
    print("changes of address:", changes, "commands:", [one.commanded for one in journey.all])
    assert changes["fast"] >= 2 * len(journey.signed) and changes["slow"] >= 2, changes
    assert orders(journey.fast, LATEST_WITH_PROOF) == []
    assert orders(journey.slow, LATEST_WITHOUT_PROOF) == []
    assert [(when, data[:16]) for when, data in journey.fast_dtls.late if when > LATEST_WITH_PROOF] == []
    assert journey.bystander.peer.commands(ARM) == []
    for forger in forgers:
        assert forger.peer.commands(ARM) == []
    for one in journey.all:
        own = [m for m in one.peer.commands(ARM) if m.target_system != one.system_id]
        assert own == [] and (one.commanded >= 3 or one is journey.bystander)


@pytest.mark.soak
def test_vehicles_keep_their_drones_for_two_minutes(server: Server, api: Api) -> None:
    travel(server, api, seconds=120)
