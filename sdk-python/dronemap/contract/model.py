"""The base of everything that a server answers and takes."""

from pydantic import BaseModel, ConfigDict
from pydantic.alias_generators import to_camel


class Model(BaseModel):
    """An object of the contract: members in Python's way of writing, on the wire as the contract has them.

    Members that this client does not know, since the server is newer, are left out.
    """

    model_config = ConfigDict(alias_generator=to_camel, populate_by_name=True, extra="ignore", defer_build=True)


class UnknownKind(Model):
    """An object of a kind that this client has no type for: all of its members as the server sent them."""

    model_config = ConfigDict(extra="allow")
