"""Types of REST and the stream: a page for those of each tag, and one for those that several share."""

from ..navigation import Nav
from .contract import SCHEMA, SHARED, Contract, Json
from .wording import Wording, plain, slug


def pages(contract: Contract) -> tuple[dict[str, str], Nav]:
    rooms: dict[str, list[str]] = {}
    for name, room in contract.rooms.items():
        rooms.setdefault(room, []).append(name)
    texts = {}
    entries: Nav = []
    for room in sorted(rooms, key=lambda each: (each != SHARED, each)):
        uri = f"reference/types/{slug(room)}.md"
        wording = Wording(contract, uri)
        title = "Types that several parts share" if room == SHARED else f"Types: {room}"
        lines = [f"# {title}", ""]
        for name in rooms[room]:
            lines += [f"## {name} {{ #{name} }}", "", *_type(contract, wording, name), ""]
        texts[uri] = "\n".join(lines)
        entries.append({"Shared" if room == SHARED else room: uri})
    return texts, [{"Types": entries}]


def _type(contract: Contract, wording: Wording, name: str) -> list[str]:
    schema = contract.schemas[name]
    lines = []
    if schema.get("description"):
        lines += [plain(schema["description"]), ""]
    users = contract.users_of_types.get(name, [])
    if users and name != "Problem":
        lines += ["Of " + ", ".join(wording.operation_link(each.tag, each.id) for each in users) + ".", ""]
    return [*lines, *_shape(wording, schema)]


def _shape(wording: Wording, schema: Json) -> list[str]:
    if isinstance(schema.get("discriminator"), dict):
        lines = [f"| `{schema['discriminator']['propertyName']}` | members |", "| --- | --- |"]
        for value, reference in schema["discriminator"]["mapping"].items():
            lines.append(f"| `{value}` | {wording.type_link(reference.removeprefix(SCHEMA))} |")
        return lines
    if "properties" in schema:
        return wording.members(schema)
    return [f"It is {wording.type_of(schema)}."]
