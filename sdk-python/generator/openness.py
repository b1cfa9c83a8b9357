"""Loosens what a server answers, so that a client understands servers that are older or newer than itself."""

from collections.abc import Iterator
from copy import deepcopy
from typing import Any

from pydantic.alias_generators import to_camel, to_snake

Schema = dict[str, Any]
_PREFIX = "#/components/schemas/"


def opened(description: Schema) -> Schema:
    """The description with every answer readable that an older or a newer server may give.

    What is not known may be left out, and so may a list, which is empty then: a server that is older does not know it
    yet. A value that this client has no name for stays text, and of several kinds of an object one may be of a kind
    that it does not know. What clients send stays as strict as it is.
    """
    loose = deepcopy(description)
    schemas = loose["components"]["schemas"]
    sent = _reached(loose, _bodies(loose))
    for name in _reached(loose, _answers(loose)):
        schema = schemas[name]
        if "oneOf" in schema:
            schema.pop("discriminator", None)
            schema["oneOf"].append({"type": "object", "additionalProperties": True})
        properties = schema.get("properties", {})
        for member, value in properties.items():
            properties[member] = _open_values(value)
        if "required" in schema:
            lists = [m for m in schema["required"] if name not in sent and _is_list(properties[m])]
            properties.update({m: properties[m] | {"default": []} for m in lists})
            schema["required"] = [m for m in schema["required"] if m not in lists and not _nullable(properties[m])]
    return loose


_BOUNDS = ("minimum", "maximum", "minLength", "maxLength", "minItems", "maxItems", "pattern")


def without_bounds(description: Schema) -> Schema:
    """The description with bounds told in words: the server alone judges them, in the same sentence for everybody."""
    told = deepcopy(description)
    for schema in told["components"]["schemas"].values():
        for member in schema.get("properties", {}).values():
            least, most = member.get("minimum"), member.get("maximum")
            if least is not None and most is not None and f"{least:g} to {most:g}" not in member.get("description", ""):
                words = member.get("description", "").rstrip(".")
                member["description"] = f"{words}, {least:g} to {most:g}" if words else f"{least:g} to {most:g}"
            for bound in _BOUNDS:
                member.pop(bound, None)
    return told


def in_pythons_way(description: Schema) -> Schema:
    """The description with members called as in Python wherever their names on the wire follow from that."""
    renamed = deepcopy(description)
    for schema in renamed["components"]["schemas"].values():
        if "properties" in schema:
            schema["properties"] = {_in_python(m): value for m, value in schema["properties"].items()}
        if "required" in schema:
            schema["required"] = [_in_python(member) for member in schema["required"]]
    return renamed


def _in_python(member: str) -> str:
    name = to_snake(member)
    return name if to_camel(name) == member else member


def _open_values(value: Schema) -> Schema:
    if "items" in value:
        return value | {"items": _open_values(value["items"])}
    names = [name for name in value.get("enum", []) if name is not None]
    if len(names) < 2 or not isinstance(names[0], str):
        return value
    kinds: list[Schema] = [{"type": "string", "enum": names}, {"type": "string"}]
    if None in value["enum"]:
        kinds.append({"type": "null"})
    return {"anyOf": kinds} | {k: v for k, v in value.items() if k == "description"}


def _is_list(value: Schema) -> bool:
    return value.get("type") == "array"


def _nullable(value: Schema) -> bool:
    kind = value.get("type")
    return (isinstance(kind, list) and "null" in kind) or {"type": "null"} in value.get("anyOf", [])


def _bodies(description: Schema) -> Iterator[Schema]:
    for operations in description["paths"].values():
        for operation in operations.values():
            yield operation.get("requestBody", {})


def _answers(description: Schema) -> Iterator[Schema]:
    for operations in description["paths"].values():
        for operation in operations.values():
            for status, response in operation["responses"].items():
                if status.startswith("2") or status == "default":
                    yield response
            yield from (r for s, r in operation["responses"].items() if s.startswith(("4", "5")))


def _reached(description: Schema, roots: Iterator[Schema]) -> list[str]:
    schemas = description["components"]["schemas"]
    found: list[str] = []
    waiting = [name for root in roots for name in _references(root)]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.append(name)
            waiting += _references(schemas[name])
    return found


def _references(value: Any) -> list[str]:
    if isinstance(value, dict):
        own = [value["$ref"].removeprefix(_PREFIX)] if "$ref" in value else []
        return own + [name for part in value.values() for name in _references(part)]
    if isinstance(value, list):
        return [name for part in value for name in _references(part)]
    return []
