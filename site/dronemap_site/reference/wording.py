"""Descriptions as Markdown: types with ranges and links, members as tables."""

import posixpath
import re
from typing import Any

from .contract import SCHEMA, Contract, Json

FORMATS = {
    "date-time": "time (UTC, ISO 8601)",
    "double": "number",
    "float": "number",
    "int32": "integer",
    "int64": "integer",
    "binary": "file",
}


def slug(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")


def cell(text: str) -> str:
    """Within a table; descriptions are plain text, so what Markdown would take for HTML is none."""
    return plain(text).replace("|", "\\|").replace("\n", " ")


def sentence(text: str) -> str:
    return text if not text or text[-1] in ".!?" else f"{text}."


def address(text: str) -> str:
    """Code that breaks between its parts, where it is too long for its column."""
    return f"<code>{text.replace('/', '/<wbr>')}</code>"


def plain(text: str) -> str:
    return re.sub(r"([*_<>\[\]])", r"\\\1", text)


class Wording:
    """Links are relative to the page that they stand in."""

    def __init__(self, contract: Contract, page: str) -> None:
        self._contract = contract
        self._folder = posixpath.dirname(page)

    def to(self, uri: str) -> str:
        return posixpath.relpath(uri, self._folder or ".")

    def type_link(self, name: str) -> str:
        if name not in self._contract.rooms:
            return f"`{name}`"
        room = self._contract.rooms[name]
        return f"[{name}]({self.to(f'reference/types/{slug(room)}.md')}#{name})"

    def operation_link(self, tag: str, operation: str) -> str:
        return f"[{operation}]({self.to(f'reference/rest/{slug(tag)}.md')}#{operation})"

    def type_of(self, schema: Json) -> str:
        """What a value is: its type, its values or its range."""
        if "$ref" in schema:
            return self.type_link(schema["$ref"].removeprefix(SCHEMA))
        for choice in ("anyOf", "oneOf"):
            if choice in schema:
                return " or ".join(self.type_of(each) for each in schema[choice])
        if "enum" in schema:
            return ", ".join(f"`{value}`" if value is not None else "null" for value in schema["enum"])
        types = schema.get("type", "any")
        names = [types] if isinstance(types, str) else list(types)
        return " or ".join(self._named(name, schema) for name in names)

    def _named(self, name: str, schema: Json) -> str:
        if name == "array":
            return f"list of {self.type_of(schema.get('items', {}))}{_bounds(schema, 'Items')}"
        if name == "object" and isinstance(schema.get("additionalProperties"), dict):
            return f"map of {self.type_of(schema['additionalProperties'])}"
        if name == "null":
            return "null"
        named = FORMATS.get(schema.get("format", ""), name) if name != "boolean" else name
        return named + _range(schema) + _bounds(schema, "Length")

    def members(self, schema: Json) -> list[str]:
        """A table of the members of an object."""
        required = set(schema.get("required", ()))
        lines = ["| member | type | about |", "| --- | --- | --- |"]
        for name, member in schema.get("properties", {}).items():
            may = "" if name in required else " (optional)"
            lines.append(f"| `{name}`{may} | {self.type_of(member)} | {about(member)} |")
        return lines if len(lines) > 2 else ["No members."]


def about(schema: Json) -> str:
    parts = [cell(sentence(str(schema.get("description", ""))))]
    if "default" in schema:
        parts.append(f"Left out: `{_value(schema['default'])}`.")
    if "example" in schema:
        parts.append(f"Such as `{_value(schema['example'])}`.")
    if "pattern" in schema:
        parts.append(f"Matches `{schema['pattern']}`.")
    return " ".join(part for part in parts if part)


def _value(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _range(schema: Json) -> str:
    least, most = schema.get("minimum"), schema.get("maximum")
    if least is not None and most is not None:
        return f", {least} to {most}"
    if least is not None:
        return f", at least {least}"
    return f", at most {most}" if most is not None else ""


def _bounds(schema: Json, what: str) -> str:
    least, most = schema.get(f"min{what}"), schema.get(f"max{what}")
    unit = "entries" if what == "Items" else "characters"
    if least is not None and most is not None:
        return f" ({least} to {most} {unit})"
    if least is not None:
        return f" (at least {least} {unit})"
    return f" (at most {most} {unit})" if most is not None else ""
