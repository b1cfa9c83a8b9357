"""Clients who write all the time, each in a way of its own, and know what the server has acknowledged.

What was under way when the server died may be there or not; what was acknowledged before must be as it was
said.
"""

import itertools
import secrets
import threading
from abc import ABC, abstractmethod

import requests

from .api import Api, Json
from .server import Server

ITEMS = [{"type": "waypoint", "latitude": 47.4, "longitude": 8.5, "altitude": 20}]


class RequestRefused(AssertionError):
    """The server answered, and did not do what it was asked for."""


class Writer(ABC):
    """One of them; one thread at a time."""

    def __init__(self) -> None:
        self.acknowledged = 0
        self.refusal: RequestRefused | None = None
        self._name = secrets.token_hex(4)
        self._numbers = itertools.count(1)

    def write(self, server: Server, enough: threading.Event) -> None:
        """On and on, until the server does not answer any more or it is enough."""
        api = Api(server.address, server.local_key())
        try:
            while not enough.is_set():
                self._write(api, f"{self._name} {next(self._numbers)}")
                self.acknowledged += 1
        except requests.RequestException:
            return  # the server died
        except RequestRefused as refusal:
            self.refusal = refusal

    @abstractmethod
    def _write(self, api: Api, name: str) -> None:
        """Notes what was acknowledged when it was."""

    @abstractmethod
    def check(self, api: Api) -> None:
        """AssertionError when something that was acknowledged is not as it was sent."""


def request(api: Api, method: str, path: str, body: Json | None = None) -> Json:
    answer = api.call(method, path, body)
    if not answer.ok:
        raise RequestRefused(f"{method} {path}: {answer.status_code} {answer.text}")
    body_of_answer: Json = answer.json() if answer.content else {}
    return body_of_answer


class MissionWriter(Writer):
    """Missions, one after the other."""

    def __init__(self) -> None:
        super().__init__()
        self._names: set[str] = set()

    def _write(self, api: Api, name: str) -> None:
        request(api, "POST", "/missions", {"name": name, "items": ITEMS})
        self._names.add(name)

    def check(self, api: Api) -> None:
        missing = self._names - {mission["name"] for mission in api.get("/missions")["missions"]}
        assert not missing, f"{len(missing)} missions are lost, as {min(missing)}"


class GroupWriter(Writer):
    """One group, which gets a new name each time: the last one, or one that was under way, is its name."""

    def __init__(self) -> None:
        super().__init__()
        self._id: str | None = None
        self._last = ""
        self._under_way: str | None = None

    def _write(self, api: Api, name: str) -> None:
        if self._id is None:
            self._id = str(request(api, "POST", "/groups", {"name": name, "members": []})["id"])
        else:
            self._under_way = name
            request(api, "PUT", f"/groups/{self._id}", {"name": name, "members": []})
        self._last, self._under_way = name, None

    def check(self, api: Api) -> None:
        if self._id is None:
            return
        (name,) = [group["name"] for group in api.get("/groups")["groups"] if group["id"] == self._id]
        assert name in (self._last, self._under_way), f"the group is called {name}, not {self._last}"
        self._last, self._under_way = name, None


class ShortLivedWriter(Writer):
    """Things that go as soon as they are there: none that is removed comes back."""

    def __init__(self, path: str, listed: str, new: str) -> None:
        """`new` names the field that the name stands in."""
        super().__init__()
        self._path = path
        self._listed = listed
        self._new = new
        self._there: set[str] = set()
        self._gone: set[str] = set()

    def _write(self, api: Api, name: str) -> None:
        made = str(request(api, "POST", self._path, self._body(name))["id"])
        self._there.add(made)
        if len(self._there) > 3:
            removed = self._there.pop()
            request(api, "DELETE", f"{self._path}/{removed}")
            self._gone.add(removed)

    def _body(self, name: str) -> Json:
        return {self._new: name, "role": "viewer"}

    def check(self, api: Api) -> None:
        there = {each["id"] for each in api.get(self._path)[self._listed]}
        assert self._there <= there, f"of {self._path} are lost: {self._there - there}"
        assert not self._gone & there, f"of {self._path} came back: {self._gone & there}"


class ZoneWriter(ShortLivedWriter):
    """Far from everybody."""

    def __init__(self) -> None:
        super().__init__("/zones", "features", "name")

    def _body(self, name: str) -> Json:
        place = {"type": "Point", "coordinates": [-31, 11]}
        return {"type": "Feature", "geometry": place, "properties": {"name": name, "radius": 50}}


def one_of_each_kind() -> list[Writer]:
    """A writer that adds, one that changes, and two that remove: of what is shared, and of a user's own."""
    return [
        MissionWriter(),
        GroupWriter(),
        ZoneWriter(),
        ShortLivedWriter("/access-keys", "accessKeys", "label"),
    ]
