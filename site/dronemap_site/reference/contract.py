"""The pinned descriptions, read once, and who may call what, as docs/security.md has it."""

import json
import re
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from .faces import Faces

Json = dict[str, Any]
WIRE = Path("dronemap-ws/src/test/resources/wire")
ROW = re.compile(r"^\| `([A-Z]+ /[^`]*)` \| (.+) \|$", re.MULTILINE)
METHODS = ("get", "post", "put", "patch", "delete")
SHARED = "Shared"
SCHEMA = "#/components/schemas/"


@dataclass(frozen=True)
class Access:
    """A row of the table of who may do what."""

    role: str
    about: str
    costs: str
    record: str


@dataclass(frozen=True)
class Operation:
    """One operation of REST."""

    method: str
    path: str
    described: Json

    @property
    def id(self) -> str:
        return str(self.described["operationId"])

    @property
    def tag(self) -> str:
        return str(self.described["tags"][0])

    @property
    def title(self) -> str:
        return str(self.described["summary"])


@dataclass
class Contract:
    rest: Json
    stream: Json
    access: dict[str, Access]
    faces: Faces
    operations: list[Operation] = field(default_factory=list)

    @classmethod
    def read(cls, root: Path) -> "Contract":
        rest: Json = json.loads((root / WIRE / "openapi.json").read_text(encoding="utf-8"))
        stream: Json = json.loads((root / WIRE / "asyncapi.json").read_text(encoding="utf-8"))
        rows = ROW.findall((root / "docs/security.md").read_text(encoding="utf-8"))
        access = {called: Access(*cells) for called, row in rows if len(cells := row.split(" | ")) == 4}
        operations = [
            Operation(method.upper(), path, methods[method])
            for path, methods in rest["paths"].items()
            for method in METHODS
            if method in methods
        ]
        return cls(rest, stream, access, Faces.read(root, WIRE), operations)

    @cached_property
    def tags(self) -> dict[str, list[Operation]]:
        """By tag, in the order of the alphabet; those without an operation are left out."""
        found: dict[str, list[Operation]] = {}
        for operation in self.operations:
            found.setdefault(operation.tag, []).append(operation)
        return dict(sorted(found.items()))

    @cached_property
    def about_tags(self) -> dict[str, str]:
        return {tag["name"]: tag["description"] for tag in self.rest["tags"]}

    @cached_property
    def schemas(self) -> dict[str, Json]:
        """Types of REST, and those that only the stream has."""
        schemas: dict[str, Json] = self.stream["components"]["schemas"] | self.rest["components"]["schemas"]
        return dict(sorted(schemas.items()))

    @cached_property
    def rooms(self) -> dict[str, str]:
        """The tag that alone needs a type, or `SHARED`; types that only the stream has are its own."""
        users: dict[str, set[str]] = {}
        for operation in self.operations:
            for name in self._needed(operation.described):
                users.setdefault(name, set()).add(operation.tag)
        rooms = {name: next(iter(tags)) if len(tags) == 1 else SHARED for name, tags in users.items()}
        return {name: rooms.get(name, "Stream") for name in self.schemas}

    @cached_property
    def users_of_types(self) -> dict[str, list[Operation]]:
        """Which operations take or answer a type by itself."""
        found: dict[str, list[Operation]] = {}
        for operation in self.operations:
            for name in sorted(set(references(operation.described))):
                found.setdefault(name, []).append(operation)
        return found

    def _needed(self, described: Json) -> set[str]:
        needed: set[str] = set()
        waiting = references(described)
        while waiting:
            name = waiting.pop()
            if name not in needed:
                needed.add(name)
                waiting += references(self.schemas[name])
        return needed


def references(value: Any) -> list[str]:
    """Names of the types that a description refers to."""
    if isinstance(value, dict):
        own = [value["$ref"].removeprefix(SCHEMA)] if str(value.get("$ref", "")).startswith(SCHEMA) else []
        return own + [name for inner in value.values() for name in references(inner)]
    if isinstance(value, list):
        return [name for inner in value for name in references(inner)]
    return []
