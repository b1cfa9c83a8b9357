"""Signing and verifying, compared with pymavlink's own signing."""

import hashlib
import time
from typing import Any

import pytest
from pymavlink.dialects.v10 import common as older
from pymavlink.dialects.v20 import all as dialect

from dronemap_signing_relay.bridge import Bridge
from dronemap_signing_relay.frames import Splitter, as_version_2, checksum, split_datagram, unsigned
from dronemap_signing_relay.signing import TICKS_PER_SECOND, Signing, wall_ticks

PASSPHRASE = "correct horse battery"
MINUTE = 60 * TICKS_PER_SECOND


def pymavlink_link(system: int = 1, passphrase: str | None = PASSPHRASE, ticks: int | None = None) -> Any:
    """pymavlink as a sender and as a reader that takes nothing unsigned."""
    made = dialect.MAVLink(None, srcSystem=system, srcComponent=1)
    made.robust_parsing = True
    if passphrase is not None:
        made.signing.secret_key = hashlib.sha256(passphrase.encode()).digest()
        made.signing.sign_outgoing = True
        made.signing.timestamp = wall_ticks() if ticks is None else ticks
        made.signing.allow_unsigned_callback = lambda *_: False
    return made


def every_message() -> list[Any]:
    """One of each kind, with numbers that leave no byte zero, and with zeros."""
    made = []
    for kind in dialect.mavlink_map.values():
        if kind.id < 0 or kind.id == dialect.MAVLINK_MSG_ID_TEST_TYPES:
            continue
        counts = dict(zip(kind.ordered_fieldnames, kind.array_lengths, strict=True))
        for value in (0, 1):
            fields: dict[str, Any] = {}
            for name, form in zip(kind.fieldnames, kind.fieldtypes, strict=True):
                text = b"x" * value
                fields[name] = (
                    text if form == "char" else [value] * counts[name] if counts[name] > 1 else value
                )
            made.append(kind(**fields))
    return made


def test_tool_messages_are_signed_as_pymavlink_accepts() -> None:
    tool, server = pymavlink_link(system=245, passphrase=None), pymavlink_link()
    bridge = Bridge(Signing(PASSPHRASE))
    for message in every_message():
        (frame,) = bridge.from_tool(bytes(message.pack(tool)))
        (received,) = server.parse_buffer(frame)
        assert received.get_type() == message.get_type()
        assert received.get_signed()
        assert received.to_dict() == message.to_dict()


def test_server_messages_reach_tool_unsigned_and_unchanged() -> None:
    server = pymavlink_link()
    plain = pymavlink_link(passphrase=None)
    bridge = Bridge(Signing(PASSPHRASE))
    for message in every_message():
        plain.seq = server.seq
        (frame,) = bridge.from_server(bytes(message.pack(server)))
        assert frame == bytes(message.pack(plain))


def test_mavlink_1_messages_are_converted_to_version_2() -> None:
    tool = older.MAVLink(None, srcSystem=7, srcComponent=3)
    bridge, server = Bridge(Signing(PASSPHRASE)), pymavlink_link()
    messages = [
        older.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3),
        older.MAVLink_command_long_message(1, 1, 400, 0, 1, 0, 0, 0, 0, 0, 0),
        older.MAVLink_param_request_list_message(0, 0),
        older.MAVLink_mission_item_message(1, 1, 0, 3, 16, 2, 1, 0, 0, 0, 0, 47.5, 8.5, 20),
    ]
    for message in messages:
        (frame,) = bridge.from_tool(bytes(message.pack(tool)))
        (received,) = server.parse_buffer(frame)
        kept = received.to_dict()
        assert {name: kept[name] for name in message.to_dict()} == message.to_dict()
        assert (received.get_srcSystem(), received.get_srcComponent()) == (7, 3)
        assert received.get_seq() == message.get_seq()


def unknown_message(seed: int) -> bytes:
    """A message of a kind that no dialect has."""
    body = bytes((3, 0, 0, 9, 1, 1, 0xF1, 0xF2, 0xF3)) + b"abc"
    return b"\xfd" + body + checksum(body + bytes((seed,))).to_bytes(2, "little")


def test_unknown_message_keeps_valid_checksum() -> None:
    for seed in (0, 99, 255):
        frame = unknown_message(seed)
        signed = Signing(PASSPHRASE).sign(frame)
        end = len(signed) - 13
        assert checksum(signed[1 : end - 2] + bytes((seed,))).to_bytes(2, "little") == signed[end - 2 : end]
        assert unsigned(signed) == frame
        assert Bridge(Signing(PASSPHRASE)).from_server(signed) == [frame]


@pytest.mark.parametrize(
    ("passphrase", "why"), [("another passphrase", "wrong signature"), (None, "unsigned")], ids=str
)
def test_unsigned_or_foreign_messages_are_dropped(passphrase: str | None, why: str) -> None:
    signing = Signing(PASSPHRASE)
    stranger = pymavlink_link(passphrase=passphrase)
    beat = dialect.MAVLink_heartbeat_message(2, 3, 0, 0, 4, 3)
    assert Bridge(signing).from_server(bytes(beat.pack(stranger))) == []
    assert signing.refused == {why: 1}


def test_tampered_frame_is_dropped() -> None:
    signing = Signing(PASSPHRASE)
    beat = dialect.MAVLink_heartbeat_message(2, 3, 0, 0, 4, 3)
    frame = bytearray(beat.pack(pymavlink_link()))
    frame[-1] ^= 1
    assert signing.verify(bytes(frame)) is None


def test_replayed_and_old_frames_are_dropped() -> None:
    signing = Signing(PASSPHRASE)
    bridge = Bridge(signing)
    beat = dialect.MAVLink_heartbeat_message(2, 3, 0, 0, 4, 3)
    server = pymavlink_link()
    first, second = (bytes(beat.pack(server)) for _ in range(2))
    assert len(bridge.from_server(second)) == 1
    assert bridge.from_server(second) == []
    assert bridge.from_server(first) == []
    old = pymavlink_link(system=2, ticks=wall_ticks() - MINUTE - TICKS_PER_SECOND)
    assert bridge.from_server(bytes(beat.pack(old))) == []
    assert signing.refused == {"seen before": 2, "more than a minute old": 1}


def test_timestamps_only_rise_and_follow_received_ones() -> None:
    ticks = [1_000 * MINUTE]
    signing = Signing(PASSPHRASE, ticks=lambda: ticks[0])
    tool = pymavlink_link(system=245, passphrase=None)
    beat = dialect.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)

    def stamp() -> int:
        return int.from_bytes(signing.sign(bytes(beat.pack(tool)))[-12:-6], "little")

    first = stamp()
    assert stamp() == first + 1
    ticks[0] -= MINUTE
    assert stamp() == first + 2
    assert signing.verify(bytes(beat.pack(pymavlink_link(ticks=first + MINUTE)))) is not None
    assert stamp() > first + MINUTE


def test_noise_and_broken_frames_lose_no_valid_frame() -> None:
    server, splitter = pymavlink_link(), Splitter()
    frames = [bytes(m.pack(server)) for m in every_message()[:40]]
    broken = bytearray(frames[0])
    broken[12] ^= 0x55
    stream = b"\xfd\x01noise\xfe" + bytes(broken) + b"".join(frames) + b"\0" * 300
    found = []
    for at in range(0, len(stream), 7):
        found += splitter.feed(stream[at : at + 7])
    assert found == frames
    assert splitter.skipped > len(broken)
    assert split_datagram(frames[1][:-1]) == []


def test_noise_like_unknown_header_loses_no_frame() -> None:
    server, splitter = pymavlink_link(), Splitter()
    frames = [bytes(m.pack(server)) for m in every_message()[:9]]
    assert splitter.feed(b"x" + unknown_message(0)[:10] + b"".join(frames)) == frames
    assert splitter.feed(unknown_message(0)) == [unknown_message(0)]


def test_heartbeats_use_system_id_of_tool() -> None:
    bridge = Bridge(Signing(PASSPHRASE))
    assert bridge.heartbeat() is None
    beat = dialect.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)
    bridge.from_tool(bytes(beat.pack(pymavlink_link(system=42, passphrase=None))))
    server = pymavlink_link()
    for number in range(300):
        frame = bridge.heartbeat()
        assert frame is not None
        (received,) = server.parse_buffer(frame)
        assert (received.get_srcSystem(), received.get_seq(), received.get_signed()) == (
            42,
            number % 256,
            True,
        )


def test_signing_is_fast_enough_for_fifty_drones() -> None:
    server, bridge = pymavlink_link(), Bridge(Signing(PASSPHRASE))
    place = dialect.MAVLink_global_position_int_message(1, 2, 3, 4, 5, 6, 7, 8, 9)
    frames = [bytes(place.pack(server)) for _ in range(2_000)]
    started = time.process_time()
    assert sum(len(bridge.from_server(frame)) for frame in frames) == len(frames)
    assert time.process_time() - started < 2


def test_zero_payload_keeps_first_byte() -> None:
    tool = older.MAVLink(None, srcSystem=7, srcComponent=3)
    frame = bytes(older.MAVLink_param_request_list_message(0, 0).pack(tool))
    assert as_version_2(frame)[1] == 1


def test_passphrase_is_not_printed() -> None:
    assert PASSPHRASE not in repr(Signing(PASSPHRASE))
