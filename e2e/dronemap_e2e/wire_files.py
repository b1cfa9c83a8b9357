"""Recorded exchanges as files: ids and secrets are replaced by numbered names, in requests too."""

import json
import re
from pathlib import Path

from .wire_relay import Exchange

IDS = (
    "id|drone|droneId|command|commandId|plan|planId|run|runId|follow|followId|flight|flightId|mission|zone"
    "|grant|group|fleet|recording|virtualDrone|virtualDroneId|endpoint|account|identity"
)
SECRETS = "key|secret|ticket|token|password|oneTimePassword|invitation"
JSON_VALUE = re.compile(rf'"(?:({IDS})|({SECRETS}|code))" : "([^"\\]+)"')
XML_VALUE = re.compile(rf"<(?:\w+:)?(?:({IDS})|({SECRETS}))>([^<\s]+)(?=<)")
COOKIE = re.compile(r"(?:(nothing)|(dronemap-session))=([^;]+)")
FILLER = re.compile(r"x{1000,}")


def readable(text: str, content_type: str) -> str:
    """A member or an element a line."""
    if "json" in content_type and text:
        return json.dumps(json.loads(text), indent=2, separators=(",", " : "), ensure_ascii=False)
    return text.replace("><", ">\n<") if "xml" in content_type else text


class PlaceholderNames:
    """Replaces ids and secrets, which differ in each server, by numbered names."""

    def __init__(self, known: dict[str, str]) -> None:
        self._names = dict(known)
        self._counts = {"id": 0, "secret": 0}
        self._chosen = ""

    def keep_request_values(self, text: str) -> None:
        """Keeps values of a request as they are: its client has chosen them."""
        self._chosen += "\n" + text

    def name_values(self, text: str) -> None:
        for pattern in (JSON_VALUE, XML_VALUE, COOKIE):
            for found in pattern.finditer(text):
                kind, value = ("id" if found[1] else "secret"), found[3]
                if value not in self._names and len(value) > 5 and value not in self._chosen:
                    self._counts[kind] += 1
                    self._names[value] = f"<{kind}-{self._counts[kind]}>"

    def with_names(self, text: str) -> str:
        for value in sorted(self._names, key=len, reverse=True):
            text = re.sub(rf"(?<![\w-]){re.escape(value)}(?![\w-])", self._names[value], text)
        return FILLER.sub(lambda found: f"<filler-{len(found[0])}>", text)


def write(exchanges: list[Exchange], folder: Path, known: dict[str, str]) -> None:
    """Each in a file, in the order in which they were asked."""
    folder.mkdir(parents=True, exist_ok=True)
    for former in folder.glob("*.txt"):
        former.unlink()
    names = PlaceholderNames(known)
    for number, one in enumerate(exchanges, start=1):
        head = "".join(f"{name}: {value}\n" for name, value in one.request_headers.items())
        request = names.with_names(f"{one.client}\n{one.method} {one.path}\n{head}\n{one.body}")
        names.keep_request_values(request)
        response_headers = "".join(f"{name}: {value}\n" for name, value in one.response_headers.items())
        answer = (
            f"{one.status} {one.content_type}\n{response_headers}\n{readable(one.answer, one.content_type)}"
        )
        names.name_values(answer)
        words = re.sub(
            r"[^A-Za-z0-9]+", "-", names.with_names(one.path.split("?")[0]).removeprefix("/api/v1/")
        )
        client = one.client.split()[0].lower()
        name = f"{number:03d}-{client}-{one.method.lower()}-{words.strip('-')[:50].strip('-')}.txt"
        text = f"{request}\n=> {names.with_names(answer)}"
        (folder / name).write_text(text.rstrip("\n") + "\n")
