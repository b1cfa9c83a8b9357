"""One page a service of SOAP: its operations, with what they take and answer."""

from ..navigation import Nav
from .contract import Contract
from .wording import Wording, cell, plain
from .wsdl import Member, Service


def pages(contract: Contract) -> tuple[dict[str, str], Nav]:
    texts = {}
    entries: Nav = []
    for service in contract.faces.services:
        uri = f"reference/soap/{service.name}.md"
        texts[uri] = _page(contract, service, uri)
        entries.append({service.name: uri})
    return texts, [{"SOAP": entries}]


def _page(contract: Contract, service: Service, uri: str) -> str:
    wording = Wording(contract, uri)
    rest = _rest_names(contract, wording)
    lines = [
        f"# {service.name}",
        "",
        f"SOAP 1.1 and 1.2 at `{service.path}`, described at `{service.path}?wsdl`; namespace `{service.namespace}`.",
        "",
    ]
    for name, operation in service.operations.items():
        lines += [f"## {name} {{ #{name} }}", ""]
        if operation.about:
            lines += [plain(operation.about), ""]
        if name in rest:
            lines += [f"In REST: {rest[name]}.", ""]
        lines += [
            *_members(wording, "takes", operation.takes),
            *_members(wording, "answers", operation.answers),
        ]
    return "\n".join(lines) + "\n"


def _rest_names(contract: Contract, wording: Wording) -> dict[str, str]:
    names = {
        operation.described.get("x-soap-name", operation.id): wording.operation_link(operation.tag, operation.id)
        for operation in contract.operations
    }
    commands = {
        operation: f"[giveCommand: {kind}]({wording.to('reference/rest/commands.md')}#command-{kind})"
        for kind, (_, operation) in contract.faces.soap_commands().items()
    }
    return names | commands


def _members(wording: Wording, verb: str, members: tuple[Member, ...]) -> list[str]:
    if not members:
        return [f"It {verb} nothing.", ""]
    lines = [f"| {verb} | type | about |", "| --- | --- | --- |"]
    for member in members:
        may = " (optional)" if member.optional and verb == "takes" else ""
        lines.append(f"| `{member.name}`{may} | {_type(wording, member.type)} | {cell(member.about)} |")
    return [*lines, ""]


def _type(wording: Wording, name: str) -> str:
    if name.startswith("ListOf"):
        return f"list of {_type(wording, name.removeprefix('ListOf'))}"
    return wording.type_link(name) if name[:1].isupper() else name
