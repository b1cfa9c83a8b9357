"""A DTLS 1.2 client written from RFC 6347, 4279, 5288 and 9146: pre-shared key, AES-128-GCM, connection id.

Python has no DTLS, and OpenSSL no connection id; this is the foreign peer that changes its address
in mid-flight.
"""

import hashlib
import hmac
import os
import socket
import struct
import time
from dataclasses import dataclass

from cryptography.hazmat.primitives.ciphers.aead import AESGCM

VERSION = b"\xfe\xfd"
CHANGE_CIPHER_SPEC, ALERT, HANDSHAKE, APPLICATION_DATA, WITH_CONNECTION_ID = 20, 21, 22, 23, 25
CLIENT_HELLO, SERVER_HELLO, HELLO_VERIFY, SERVER_KEY_EXCHANGE = 1, 2, 3, 12
SERVER_HELLO_DONE, CLIENT_KEY_EXCHANGE, FINISHED = 14, 16, 20
PSK_AES_128_GCM_SHA256 = b"\x00\xa8"
CONNECTION_ID_EXTENSION = 54


class HandshakeError(Exception):
    """The server did not let this client in."""


@dataclass(frozen=True)
class Record:
    kind: int
    epoch: int
    sequence: int
    fragment: bytes

    def number(self) -> bytes:
        return struct.pack("!HHI", self.epoch, self.sequence >> 32, self.sequence & 0xFFFFFFFF)


def _prf(secret: bytes, label: bytes, seed: bytes, length: int) -> bytes:
    seed = label + seed
    out, a = b"", seed
    while len(out) < length:
        a = hmac.digest(secret, a, "sha256")
        out += hmac.digest(secret, a + seed, "sha256")
    return out[:length]


class DtlsClient:
    """One connection."""

    def __init__(self, server: tuple[str, int], identity: str, key: bytes, timeout: float = 5.0) -> None:
        self._server = server
        self._identity = identity.encode()
        self._key = key
        self._socket = self._open()
        self._sequence = [0, 0]
        self._message = 0
        self._transcript = b""
        self._random = os.urandom(32)
        self.connection_id = b""
        self._ours: tuple[AESGCM, bytes] | None = None
        self._theirs: tuple[AESGCM, bytes] | None = None
        self._handshake_with_server(time.monotonic() + timeout)

    @property
    def port(self) -> int:
        port: int = self._socket.getsockname()[1]
        return port

    def send(self, data: bytes) -> None:
        self._send(APPLICATION_DATA, data, 1)

    def receive(self, timeout: float = 0.2) -> bytes:
        """Application data of one datagram; empty when nothing came in time."""
        self._socket.settimeout(timeout)
        try:
            datagram = self._socket.recv(65535)
        except (TimeoutError, ConnectionError):
            return b""
        records = [r for r in _records(datagram) if r.epoch == 1]
        return b"".join(self._decrypted(r) for r in records if r.kind == APPLICATION_DATA)

    def close(self) -> None:
        self._send(ALERT, b"\x01\x00", 1)
        self._socket.close()

    def _open(self) -> socket.socket:
        opened = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        opened.connect(self._server)
        return opened

    def _handshake_with_server(self, deadline: float) -> None:
        self._hello(b"")
        (kind, body), *_ = self._messages({HELLO_VERIFY}, deadline)
        assert kind == HELLO_VERIFY, f"expected a hello verify request, got {kind}"
        self._transcript = b""
        self._hello(body[3 : 3 + body[2]])
        server_random = b""
        for kind, body in self._messages({SERVER_HELLO_DONE}, deadline):
            if kind == SERVER_HELLO:
                server_random = body[2:34]
                self.connection_id = _connection_id(body)
        self._send_handshake(CLIENT_KEY_EXCHANGE, struct.pack("!H", len(self._identity)) + self._identity)
        zeros = bytes(len(self._key))
        size = struct.pack("!H", len(self._key))
        premaster = size + zeros + size + self._key
        master = _prf(premaster, b"master secret", self._random + server_random, 48)
        block = _prf(master, b"key expansion", server_random + self._random, 40)
        self._ours = (AESGCM(block[:16]), block[32:36])
        self._theirs = (AESGCM(block[16:32]), block[36:40])
        self._send(CHANGE_CIPHER_SPEC, b"\x01", 0)
        digest = hashlib.sha256(self._transcript).digest()
        self._send_handshake(FINISHED, _prf(master, b"client finished", digest, 12), 1)
        digest = hashlib.sha256(self._transcript).digest()
        finished = [body for kind, body in self._messages({FINISHED}, deadline) if kind == FINISHED]
        if finished != [_prf(master, b"server finished", digest, 12)]:
            raise HandshakeError("the server's Finished is not right")

    def _hello(self, cookie: bytes) -> None:
        connection_id = struct.pack("!HHB", CONNECTION_ID_EXTENSION, 1, 0)
        body = VERSION + self._random + b"\x00" + bytes([len(cookie)]) + cookie
        body += b"\x00\x02" + PSK_AES_128_GCM_SHA256 + b"\x01\x00"
        body += struct.pack("!H", len(connection_id)) + connection_id
        self._send_handshake(CLIENT_HELLO, body)

    def _send_handshake(self, kind: int, body: bytes, epoch: int = 0) -> None:
        message = _handshake(kind, self._message, body)
        self._message += 1
        self._transcript += message
        self._send(HANDSHAKE, message, epoch)

    def _messages(self, until: set[int], deadline: float) -> list[tuple[int, bytes]]:
        """Handshake messages up to one of these kinds; a message is never in parts here, all are small."""
        received: list[tuple[int, bytes]] = []
        while not received or received[-1][0] not in until:
            self._socket.settimeout(max(0.01, deadline - time.monotonic()))
            try:
                datagram = self._socket.recv(65535)
            except (TimeoutError, ConnectionError) as e:
                raise HandshakeError("the server does not answer") from e
            for record in _records(datagram):
                if record.kind == ALERT and record.epoch == 0 and record.fragment[:1] == b"\x02":
                    raise HandshakeError(f"the server sent the alert {record.fragment[1]}")
                if record.kind != HANDSHAKE:
                    continue
                plain = record.fragment if record.epoch == 0 else self._decrypted(record)
                while plain:
                    length = int.from_bytes(plain[1:4], "big")
                    message, plain = plain[: 12 + length], plain[12 + length :]
                    self._transcript += message
                    received.append((message[0], message[12:]))
        return received

    def _send(self, kind: int, plain: bytes, epoch: int) -> None:
        sequence = self._sequence[epoch]
        self._sequence[epoch] += 1
        record = Record(kind, epoch, sequence, plain)
        if epoch == 0:
            header = bytes([kind]) + VERSION + record.number() + struct.pack("!H", len(plain))
            self._socket.send(header + plain)
            return
        assert self._ours is not None
        cipher, salt = self._ours
        head = VERSION + record.number()
        if self.connection_id:
            plain += bytes([kind])
            wire, cid = bytes([WITH_CONNECTION_ID]), self.connection_id
            extra = b"\xff" * 8 + wire + bytes([len(cid)]) + wire + head + cid + struct.pack("!H", len(plain))
        else:
            wire, cid = bytes([kind]), b""
            extra = record.number() + wire + VERSION + struct.pack("!H", len(plain))
        sealed = record.number() + cipher.encrypt(salt + record.number(), plain, extra)
        self._socket.send(wire + head + cid + struct.pack("!H", len(sealed)) + sealed)

    def _decrypted(self, record: Record) -> bytes:
        assert self._theirs is not None
        cipher, salt = self._theirs
        nonce, sealed = record.fragment[:8], record.fragment[8:]
        extra = record.number() + bytes([record.kind]) + VERSION + struct.pack("!H", len(sealed) - 16)
        return cipher.decrypt(salt + nonce, sealed, extra)


def _handshake(kind: int, number: int, body: bytes) -> bytes:
    length = len(body).to_bytes(3, "big")
    return bytes([kind]) + length + struct.pack("!H", number) + b"\x00\x00\x00" + length + body


def _records(datagram: bytes) -> list[Record]:
    """We asked for no connection id of our own: records to us have none."""
    records = []
    while len(datagram) >= 13:
        epoch, high, low, length = struct.unpack("!HHIH", datagram[3:13])
        records.append(Record(datagram[0], epoch, high << 32 | low, datagram[13 : 13 + length]))
        datagram = datagram[13 + length :]
    return records


def _connection_id(server_hello: bytes) -> bytes:
    """The id that the server wants to see in our records; empty when it wants none."""
    at = 34 + 1 + server_hello[34] + 3
    end = at + 2 + int.from_bytes(server_hello[at : at + 2], "big")
    at += 2
    while at + 4 <= end:
        kind, length = struct.unpack("!HH", server_hello[at : at + 4])
        if kind == CONNECTION_ID_EXTENSION:
            return server_hello[at + 5 : at + 4 + length]
        at += 4 + length
    return b""
