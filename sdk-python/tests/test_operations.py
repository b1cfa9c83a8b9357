"""Each operation of the contract has a typed call, which sends what the description says."""

import asyncio
import inspect
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, get_args, get_type_hints

import pytest
from pydantic import TypeAdapter
from pydantic.alias_generators import to_snake

from dronemap.contract import models
from dronemap.contract.call import Call
from dronemap.contract.operations import Operations
from dronemap.sender import Sender
from dronemap.sync.operations import SyncOperations
from dronemap.transport import HttpAnswer
from generator.__main__ import main

DESCRIPTION = json.loads((Path(__file__).parents[2] / "dronemap-ws/src/test/resources/wire/openapi.json").read_text())
SCHEMAS: dict[str, Any] = DESCRIPTION["components"]["schemas"]


def described() -> Iterator[tuple[str, str, dict[str, Any]]]:
    for path, operations in DESCRIPTION["paths"].items():
        for method, operation in operations.items():
            yield path, method.upper(), operation


class Recording:
    """Keeps what was asked, and answers with the least that the description allows."""

    def __init__(self, answer: bytes) -> None:
        self.answer = answer
        self.asked: tuple[str, str, Mapping[str, str], Any, str | None] | None = None

    async def request(
        self,
        method: str,
        path: str,
        *,
        query: Mapping[str, str],
        content: bytes | None = None,
        content_type: str | None = None,
    ) -> HttpAnswer:
        self.asked = (method, path, query, content, content_type)
        return HttpAnswer(200, {}, self.answer)

    def stream(self, port: int) -> Any:
        raise AssertionError("REST alone")

    async def close(self) -> None:
        return None


def least(schema: dict[str, Any]) -> Any:
    """The least that a schema allows."""
    if "$ref" in schema:
        return least(SCHEMAS[schema["$ref"].rpartition("/")[2]])
    if "oneOf" in schema:
        return least(schema["oneOf"][0])
    if "anyOf" in schema:
        return None if {"type": "null"} in schema["anyOf"] else least(schema["anyOf"][0])
    kind = schema.get("type")
    if isinstance(kind, list):
        return None
    if "enum" in schema:
        return schema["enum"][0]
    if kind == "object":
        required = schema.get("required", [])
        return {name: least(part) for name, part in schema.get("properties", {}).items() if name in required}
    if kind == "array":
        return [least(schema["items"])] * schema.get("minItems", 0)
    if schema.get("format") == "date-time":
        return "2026-01-01T00:00:00Z"
    number = max(schema.get("minimum", 0), 0)
    text = "x" * max(1, schema.get("minLength", 1))
    return {"string": text, "integer": number, "number": float(number), "boolean": False}[str(kind)]


@pytest.mark.parametrize(
    ("path", "method", "operation"), [pytest.param(*case, id=case[2]["operationId"]) for case in described()]
)
def test_each_operation_sends_what_is_described(path: str, method: str, operation: dict[str, Any]) -> None:
    call = getattr(Operations, to_snake(operation["operationId"]))
    content = content_of(operation)
    recording = Recording(answer_of(operation))
    given, places = arguments(call, operation, content)
    answer = asyncio.run(getattr(Operations(Sender(recording, 0)), call.__name__)(**given))

    assert recording.asked is not None
    asked_method, asked_path, query, body, content_type = recording.asked
    assert asked_method == method
    assert "/api/v1" + asked_path == path.format(**places)
    expected = {p["name"] for p in operation.get("parameters", []) if p["in"] == "query"}
    assert set(query) == expected
    if content is None:
        assert body is None
    elif isinstance(content, bytes):
        assert body == content
        assert content_type in operation["requestBody"]["content"]
    else:
        assert json.loads(body) == {name: value for name, value in content.items() if value is not None}
        assert content_type == "application/json"
    hint = get_type_hints(call)["return"]
    assert isinstance(answer, hint) if isinstance(hint, type) else answer is not None


def content_of(operation: dict[str, Any]) -> Any:
    if "requestBody" not in operation:
        return None
    contents = operation["requestBody"]["content"]
    if list(contents) != ["application/json"]:
        return b"bytes"
    found: dict[str, Any] = least(contents["application/json"]["schema"])
    return found


def answer_of(operation: dict[str, Any]) -> bytes:
    for status, response in operation["responses"].items():
        for kind, content in response.get("content", {}).items():
            if status.startswith("2"):
                return json.dumps(least(content["schema"])).encode() if kind == "application/json" else b"bytes"
    return b""


def arguments(call: Any, operation: dict[str, Any], content: Any) -> tuple[dict[str, Any], dict[str, str]]:
    given: dict[str, Any] = {}
    places: dict[str, str] = {}
    for name in inspect.signature(call).parameters:
        if name in ("self", "content_type"):
            continue
        if name == "body":
            given[name] = content if isinstance(content, bytes) else read(call, content)
            continue
        described = next(p for p in operation["parameters"] if to_snake(p["name"]) == name.rstrip("_"))
        kind = get_type_hints(call)[name]
        plain = next((k for k in (*get_args(kind), kind) if k in (str, int, float, bool)), str)
        given[name] = plain(1)
        if described["in"] == "path":
            places[described["name"]] = str(given[name])
    if "content_type" in inspect.signature(call).parameters:
        given["content_type"] = next(iter(operation["requestBody"]["content"]))
    return given, places


def read(call: Any, content: Any) -> Any:

    return TypeAdapter(get_type_hints(call)["body"]).validate_python(content)


def test_sync_and_awaited_calls_are_the_same() -> None:
    awaited = {n: inspect.signature(f) for n, f in inspect.getmembers(Operations, inspect.isfunction)}
    plain = {n: inspect.signature(f) for n, f in inspect.getmembers(SyncOperations, inspect.isfunction)}
    del awaited["__init__"], plain["__init__"]
    assert awaited == plain
    assert set(awaited) == {to_snake(operation["operationId"]) for _, _, operation in described()}


def test_content_of_a_wrong_type_is_refused_before_it_is_sent() -> None:
    call = Call("addMission", "POST", "/missions", body={"name": "a dict"})
    with pytest.raises(TypeError, match="addMission"):
        call.content()


def test_names_in_the_path_are_escaped() -> None:
    recording = Recording(b"{}")
    asyncio.run(Operations(Sender(recording, 0)).delete_user("a/b c?"))
    assert recording.asked is not None
    assert recording.asked[1] == "/users/a%2Fb%20c%3F"


def test_models_are_as_the_description_gives_them() -> None:

    assert main(["--check"]) == 0
    assert models.DroneView.model_fields["flight"].default is None
