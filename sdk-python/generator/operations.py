"""Writes a typed call for each operation of REST, for programs that await and for those that do not."""

import keyword
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pydantic.alias_generators import to_snake

_BASE = "/api/v1"
_JSON = "application/json"
_KINDS = {"string": "str", "integer": "int", "number": "float", "boolean": "bool"}
_WIDTH = 120


@dataclass(frozen=True)
class Parameter:
    """A parameter of the address, or the body."""

    name: str
    wire: str
    type: str
    required: bool

    def declared(self) -> str:
        return f"{self.name}: {self.type}" if self.required else f"{self.name}: {self.type} | None = None"


@dataclass(frozen=True)
class Operation:
    """One operation of REST as Python calls it."""

    name: str
    wire_name: str
    method: str
    path: str
    words: str
    in_path: list[Parameter]
    in_query: list[Parameter]
    body: Parameter | None
    body_types: list[str]
    answer: str

    @property
    def parameters(self) -> str:
        given = [p.declared() for p in self.in_path]
        if self.body is not None:
            given.append(self.body.declared())
        named = [q.declared() for q in self.in_query]
        if len(self.body_types) > 1:
            kinds = ", ".join(f'"{kind}"' for kind in self.body_types)
            named.insert(0, f"content_type: Literal[{kinds}]")
        return ", ".join(["self", *given, *(["*", *named] if named else [])])

    @property
    def passed_on(self) -> str:
        given = [p.name for p in self.in_path] + ([self.body.name] if self.body else [])
        named = ["content_type"] if len(self.body_types) > 1 else []
        return ", ".join(given + [f"{n}={n}" for n in named + [q.name for q in self.in_query]])


def operations_of(description: dict[str, Any]) -> list[Operation]:
    """In the order of their names."""
    found = [
        _operation(path, method, operation)
        for path, operations in description["paths"].items()
        for method, operation in operations.items()
    ]
    return sorted(found, key=lambda operation: operation.name)


def _operation(path: str, method: str, operation: dict[str, Any]) -> Operation:
    parameters = [(p["in"], _parameter(p)) for p in operation.get("parameters", [])]
    body, body_types = _body(operation.get("requestBody"))
    words = " ".join(filter(None, [operation["summary"] + ".", operation.get("description", "")]))
    return Operation(
        name=to_snake(operation["operationId"]),
        wire_name=operation["operationId"],
        method=method.upper(),
        path=path.removeprefix(_BASE),
        words=words,
        in_path=[p for place, p in parameters if place == "path"],
        in_query=[p for place, p in parameters if place == "query"],
        body=body,
        body_types=body_types,
        answer=_answer(operation["responses"]),
    )


def _parameter(parameter: dict[str, Any]) -> Parameter:
    name = to_snake(parameter["name"])
    kind = parameter["schema"].get("type", "string")
    kinds = [k for k in kind if k != "null"] if isinstance(kind, list) else [kind]
    items = parameter["schema"].get("items", {}).get("type", "string")
    typed = f"Sequence[{_KINDS[items]}]" if kinds == ["array"] else _KINDS[kinds[0]]
    return Parameter(name + "_" * keyword.iskeyword(name), parameter["name"], typed, parameter.get("required", False))


def _body(body: dict[str, Any] | None) -> tuple[Parameter | None, list[str]]:
    if body is None:
        return None, []
    types = list(body["content"])
    kind = "models." + _name(body["content"][_JSON]["schema"]) if types == [_JSON] else "bytes"
    return Parameter("body", "body", kind, body.get("required", False)), types


def _answer(responses: dict[str, Any]) -> str:
    contents = [r.get("content", {}) for status, r in responses.items() if status.startswith("2")]
    kinds = {
        "models." + _name(content["schema"]) if kind == _JSON else "bytes"
        for c in contents
        for kind, content in c.items()
    }
    if len(kinds) > 1:
        raise SystemExit(f"One operation answers with several kinds: {kinds}")
    if not kinds:
        return "str" if "302" in responses else "None"
    return kinds.pop()


def _name(schema: dict[str, Any]) -> str:
    return str(schema["$ref"]).rpartition("/")[2]


_CLASS = "The operations of REST under their names; each raises a `Problem` when the server refuses it."
_HEAD = '''"""{words}

Written from the description of REST by `python -m generator`.
"""

# ruff: noqa: E501

from collections.abc import Sequence
from typing import Literal

from dronemap.contract import models
'''


def awaited(operations: list[Operation]) -> str:
    """The class whose calls are awaited."""
    head = _HEAD.format(words="A call for each operation of REST, awaited.")
    head += "from dronemap.contract.call import Call, CallSender, placed\n\n\n"
    head += "class Operations:\n"
    head += f'    """{_CLASS}"""\n\n'
    head += "    def __init__(self, sender: CallSender) -> None:\n        self._sender = sender\n"
    return head + "".join(line for operation in operations for line in _awaited(operation))


def _awaited(operation: Operation) -> Iterator[str]:
    yield f"\n    async def {operation.name}({operation.parameters}) -> {operation.answer}:\n"
    yield _docstring(operation.words)
    path = f'"{operation.path}"'
    if operation.in_path:
        places = ", ".join(f"{p.wire}={p.name}" for p in operation.in_path)
        path = f"placed({path}, {places})"
    parts = [f'"{operation.wire_name}"', f'"{operation.method}"', path]
    if operation.in_query:
        parts.append("query={" + ", ".join(f'"{q.wire}": {q.name}' for q in operation.in_query) + "}")
    if operation.body is not None:
        parts.append(f"body={operation.body.name}")
        if operation.body_types != [_JSON]:
            several = len(operation.body_types) > 1
            parts.append("content_type=" + ("content_type" if several else f'"{operation.body_types[0]}"'))
    yield f"        call = Call({', '.join(parts)})\n"
    if operation.answer == "None":
        yield "        await self._sender.send(call, None)\n"
    else:
        yield f"        return await self._sender.send(call, {operation.answer})\n"


def plain(operations: list[Operation]) -> str:
    """The class whose calls return when they are answered."""
    head = _HEAD.format(words="A call for each operation of REST that returns when it is answered.")
    head += "from dronemap.contract.operations import Operations\n"
    head += "from dronemap.sync.loop import LoopThread\n\n\n"
    head += "class SyncOperations:\n"
    head += f'    """{_CLASS}"""\n\n'
    head += "    def __init__(self, loop: LoopThread, awaited: Operations) -> None:\n"
    head += "        self._loop = loop\n        self._awaited = awaited\n"
    return head + "".join(line for operation in operations for line in _plain(operation))


def _plain(operation: Operation) -> Iterator[str]:
    yield f"\n    def {operation.name}({operation.parameters}) -> {operation.answer}:\n"
    yield _docstring(operation.words)
    yield f"        return self._loop.run(self._awaited.{operation.name}({operation.passed_on}))\n"


def _docstring(words: str) -> str:
    escaped = words.replace("\\", "\\\\")
    lines = textwrap.wrap(escaped, _WIDTH - 14)
    if len(lines) == 1:
        return f'        """{lines[0]}"""\n'
    first, *others = lines
    return f'        """{first}\n' + "".join(f"        {line}\n" for line in others) + '        """\n'
