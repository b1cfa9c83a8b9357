"""Records the statuses that REST answers with; a whole run compares them with those listed."""

import os
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import requests

_FOLDER = os.environ.get("DRONEMAP_SEEN_STATUSES")
_seen: set[str] = set()


def note(answer: requests.Response, *_: Any, **__: Any) -> None:
    """A hook of `requests`; writes a line for each address and status when it is first seen."""
    line = f"{answer.request.method} {urlsplit(answer.url).path} {answer.status_code}\n"
    if _FOLDER and line not in _seen:
        _seen.add(line)
        with Path(_FOLDER, f"e2e-{os.getpid()}.txt").open("a", encoding="utf-8") as file:
            file.write(line)
