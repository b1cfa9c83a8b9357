"""One call of an operation, before it is sent."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeVar
from urllib.parse import quote

from pydantic import BaseModel

QueryValue = str | int | float | bool | Sequence[Any] | None
Answer = TypeVar("Answer")
JSON = "application/json"


@dataclass(frozen=True)
class Call:
    """The call of an operation: its name, method, path below /api/v1, query and body."""

    operation: str
    method: str
    path: str
    query: Mapping[str, QueryValue] = field(default_factory=dict)
    body: Any = None
    content_type: str = JSON

    def content(self) -> bytes | None:
        """The body as it is sent; what is None is left out."""
        if self.body is None or isinstance(self.body, bytes):
            return self.body
        if not isinstance(self.body, BaseModel):
            raise TypeError(f"The body of {self.operation} must be a model or bytes, not {type(self.body).__name__}.")
        return self.body.model_dump_json(by_alias=True, exclude_none=True).encode()

    @property
    def acts_once(self) -> bool:
        """Whether it may be sent twice and acts once: it reads, sets or removes, or has an id of the caller's own."""
        return self.method in ("GET", "PUT", "DELETE") or (
            self.operation == "giveCommand" and getattr(self.body, "id", None) is not None
        )


class CallSender(Protocol):
    """Whatever brings calls to a server."""

    async def send(self, call: Call, answer: type[Answer] | None) -> Answer:
        """The answer as that type; bytes as they are, and None where nothing is answered."""


def placed(path: str, **places: str | int) -> str:
    """The path with its places filled in."""
    return path.format(**{name: quote(str(value), safe="") for name, value in places.items()})
