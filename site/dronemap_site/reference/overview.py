"""The first page of the reference: what the faces are, and all operations by name."""

from ..navigation import Nav
from .contract import Contract
from .wording import Wording, plain, slug

URI = "reference/index.md"


def pages(contract: Contract) -> tuple[dict[str, str], Nav]:
    wording = Wording(contract, URI)
    lines = [
        "# Interfaces",
        "",
        "Each operation of REST, SOAP and the stream: who may call it, its members, and its name in the clients for "
        "[Python](../sdk-python/README.md) and [TypeScript](../sdk-typescript/README.md). It is written from the "
        "descriptions that a server gives: `/api/openapi.json`, `/api/asyncapi.json`, `/services/NAME?wsdl`.",
        "",
        f"{plain(contract.rest['info']['description'])}",
        "",
        f"A refusal is a {wording.type_link('Problem')} with a [code](../problems.md).",
        "",
        "## REST by subject",
        "",
        "| subject | operations | |",
        "| --- | --- | --- |",
    ]
    for tag, operations in contract.tags.items():
        about = plain(contract.about_tags.get(tag, "")).replace("|", "\\|")
        lines.append(f"| [{tag}](rest/{slug(tag)}.md) | {len(operations)} | {about} |")
    lines += ["", "## SOAP by service", "", "| service | operations |", "| --- | --- |"]
    for service in contract.faces.services:
        lines.append(f"| [{service.name}](soap/{service.name}.md) | {len(service.operations)} |")
    lines += ["", "## All operations", "", "| operation | what it does |", "| --- | --- |"]
    for operation in sorted(contract.operations, key=lambda each: each.id):
        lines.append(f"| {wording.operation_link(operation.tag, operation.id)} | {operation.title} |")
    return {URI: "\n".join(lines) + "\n"}, [URI]
