"""One page a tag of REST: each operation, with its name in each face."""

import re

from ..navigation import Nav
from .contract import SCHEMA, Contract, Json, Operation
from .wording import Wording, about, address, plain, slug

COMMANDS = "CommandRequest"


def pages(contract: Contract) -> tuple[dict[str, str], Nav]:
    texts = {}
    entries: Nav = []
    for tag, operations in contract.tags.items():
        uri = f"reference/rest/{slug(tag)}.md"
        texts[uri] = _page(contract, tag, operations, uri)
        entries.append({tag: uri})
    return texts, [{"REST": entries}]


def _page(contract: Contract, tag: str, operations: list[Operation], uri: str) -> str:
    wording = Wording(contract, uri)
    lines = [f"# {tag}", "", plain(contract.about_tags.get(tag, "")), ""]
    # Who searches for an operation means its own part of the page, and not this list.
    lines += ["<div data-search-exclude markdown>", "", "| operation | | method and address |", "| --- | --- | --- |"]
    for operation in operations:
        called = address(f"{operation.method} {operation.path}")
        lines.append(f"| [{operation.id}](#{operation.id}) | {operation.title} | {called} |")
    lines += ["", "</div>"]
    for operation in operations:
        lines += ["", *_operation(contract, wording, operation)]
        if any(body == COMMANDS for body in _body_types(operation)) and operation.id == "giveCommand":
            lines += ["", *_commands(contract, wording)]
    return "\n".join(lines) + "\n"


def _operation(contract: Contract, wording: Wording, operation: Operation) -> list[str]:
    lines = [f"## {operation.title} {{ #{operation.id} }}", ""]
    lines += ["```http", f"{operation.method} {operation.path}", "```", ""]
    description = operation.described.get("description")
    if description:
        lines += [plain(description), ""]
    lines += _access(contract, wording, operation)
    lines += _names(contract, wording, operation)
    lines += _parameters(wording, operation)
    lines += _body(contract, wording, operation)
    lines += _answers(wording, operation)
    return lines


def _access(contract: Contract, wording: Wording, operation: Operation) -> list[str]:
    access = contract.access.get(f"{operation.method} {operation.path}")
    if access is None:
        return []
    security = wording.to("security.md")
    return [
        f"Who may: **{access.role}**, about: {access.about}; costs: {access.costs}; "
        f"activity log: {access.record} ([roles and limits]({security}#rest)).",
        "",
    ]


def _names(contract: Contract, wording: Wording, operation: Operation) -> list[str]:
    faces = contract.faces
    lines = [
        "| face | name |",
        "| --- | --- |",
        f"| REST | `{operation.id}` |",
        f"| SOAP | {_soap(contract, wording, operation)} |",
    ]
    if operation.id in faces.python:
        lines.append(f"| Python | `server.rest.{_in_cell(faces.python[operation.id])}` |")
    if operation.id in faces.typescript:
        lines.append(f"| TypeScript | `dronemap.rest.{_in_cell(faces.typescript[operation.id])}` |")
    return [*lines, ""]


def _in_cell(code: str) -> str:
    return code.replace("models.", "")


def _soap(contract: Contract, wording: Wording, operation: Operation) -> str:
    without = operation.described.get("x-without-soap")
    if without:
        return f"none: {plain(str(without))}"
    name = operation.described.get("x-soap-name", operation.id)
    services = contract.faces.soap(name)
    if not services:
        return "one operation for each kind of command, as [below](#commands)"
    return ", ".join(f"[{service}.{name}]({wording.to(f'reference/soap/{service}.md')}#{name})" for service in services)


def _parameters(wording: Wording, operation: Operation) -> list[str]:
    parameters = operation.described.get("parameters", [])
    if not parameters:
        return []
    lines = ["| parameter | in | type | about |", "| --- | --- | --- | --- |"]
    for parameter in parameters:
        may = "" if parameter.get("required") else " (optional)"
        schema: Json = parameter.get("schema", {})
        told = about(
            {"description": parameter.get("description", "")}
            | {key: schema[key] for key in ("default", "example", "pattern") if key in schema}
        )
        lines.append(f"| `{parameter['name']}`{may} | {parameter['in']} | {wording.type_of(schema)} | {told} |")
    return [*lines, ""]


def _contents(described: Json) -> dict[str, Json]:
    return {kind: content.get("schema", {}) for kind, content in described.get("content", {}).items()}


def _body_types(operation: Operation) -> list[str]:
    contents = _contents(operation.described.get("requestBody", {}))
    return [str(schema.get("$ref", "")).removeprefix(SCHEMA) for schema in contents.values()]


def _body(contract: Contract, wording: Wording, operation: Operation) -> list[str]:
    body = operation.described.get("requestBody")
    if not body:
        return []
    lines = []
    for kind, schema in _contents(body).items():
        must = "" if body.get("required") else ", may be left out"
        lines += [f"Body: {wording.type_of(schema)} (`{kind}`{must})", ""]
        name = str(schema.get("$ref", "")).removeprefix(SCHEMA)
        if "properties" in contract.schemas.get(name, {}):
            lines += [*wording.members(contract.schemas[name]), ""]
    return lines


def _answers(wording: Wording, operation: Operation) -> list[str]:
    lines = ["| status | answer |", "| --- | --- |"]
    refused = []
    for status, answer in operation.described["responses"].items():
        contents = _contents(answer)
        if "application/problem+json" in contents:
            refused.append(f"{status} {answer['description']}")
            continue
        kinds = ", ".join(
            f"{wording.type_of(schema)}" + ("" if kind == "application/json" else f" (`{kind}`)")
            for kind, schema in contents.items()
        )
        lines.append(f"| {status} {answer['description']} | {kinds or 'nothing'} |")
    if refused:
        problems = wording.to("problems.md")
        lines.append(
            f"| {', '.join(refused)} | {wording.type_link('Problem')}, with one of these [codes]({problems}) |"
        )
    return lines


def _commands(contract: Contract, wording: Wording) -> list[str]:
    """Each kind of command by itself: people look for these, and not for the operation that takes them."""
    purposes: Json = contract.schemas[COMMANDS].get("x-purposes", {})
    names = contract.faces.soap_commands()
    lines = [
        "## Commands { #commands }",
        "",
        f"What the body of `giveCommand` says, by its `type`; members: {wording.type_link(COMMANDS)}.",
        "",
    ]
    for kind, reference in contract.schemas[COMMANDS]["discriminator"]["mapping"].items():
        name = reference.removeprefix(SCHEMA)
        schema = contract.schemas[name]
        lines += [f"### {kind} {{ #command-{kind} }}", ""]
        told = schema.get("description") or purposes.get(kind)
        if told:
            lines += [plain(str(told)), ""]
        lines += [
            "| face | name |",
            "| --- | --- |",
            f'| REST, stream | {wording.type_link(name)}: `{{"type": "{kind}", …}}` |',
        ]
        if kind in names:
            service, operation = names[kind]
            lines.append(
                f"| SOAP | [{service}.{operation}]({wording.to(f'reference/soap/{service}.md')}#{operation}) |"
            )
        snake = re.sub(r"(?<!^)(?=[A-Z])", "_", kind).lower()
        given = f"`drone.give({name}(…))`"
        lines.append(f"| Python | {f'`drone.{snake}(…)`, ' if snake in contract.faces.drone_methods else ''}{given} |")
        lines.append(f"| TypeScript | `drone.command({{ type: '{kind}', … }})` |")
        lines += ["", *wording.members(schema), ""]
    return lines
