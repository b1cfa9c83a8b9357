"""Each operation of SOAP as a program of another maker calls it; read operations match REST."""

from collections.abc import Iterator
from datetime import datetime
from typing import Any

import pytest
import zeep
import zeep.exceptions
import zeep.helpers
import zeep.xsd
from requests import Session

from dronemap_e2e.api import Api, Json
from dronemap_e2e.server import Server

SERVICES = (
    "AccountService",
    "DispatchService",
    "FleetService",
    "FollowerService",
    "MAVLinkControllerService",
    "PlanningService",
    "RecordService",
    "RecoveryService",
    "ServerService",
    "VirtualDroneService",
)
VERSIONS = ("1.1", "1.2")
ZONE = {
    "type": "Feature",
    "geometry": {"type": "Point", "coordinates": [10.0, 60.0]},
    "properties": {"name": "A pond", "kind": "exclusion", "radius": 50},
}
MISSION = {"name": "A survey", "items": [{"type": "takeOff", "altitude": 20}]}


class Caller:
    """zeep at each service, in one version of SOAP."""

    def __init__(self, server: Server, key: str, version: str) -> None:
        self._operations: dict[str, tuple[Any, Any]] = {}
        for service in SERVICES:
            session = Session()
            transport: Any = zeep.transports.Transport(session=session)  # type: ignore[no-untyped-call]
            client: Any = zeep.Client(  # type: ignore[no-untyped-call]
                f"{server.address}/services/{service}?wsdl", transport=transport
            )
            session.headers["Authorization"] = f"Bearer {key}"
            ports = client.wsdl.services[service].ports
            port = next(name for name in ports if name.endswith("12") == (version == "1.2"))
            proxy = client.bind(service, port)
            for name, operation in ports[port].binding.all().items():
                assert name not in self._operations, f"{name} is in two services"
                self._operations[name] = (proxy, operation.input.body.type)

    def names(self) -> set[str]:
        return set(self._operations)

    def made(self, name: str) -> Json:
        """Arguments as the schema has them: nothing is called so, and what need not be there is left out."""
        return {
            member: _value(element.type)
            for member, element in self._operations[name][1].elements
            if not element.is_optional
        }

    def call(self, name: str, arguments: Json) -> Any:
        return getattr(self._operations[name][0], name)(**arguments)


def _value(kind: Any) -> Any:
    if isinstance(kind, zeep.xsd.ComplexType):
        return {name: _value(element.type) for name, element in kind.elements if not element.is_optional}
    if isinstance(kind, zeep.xsd.Boolean):
        return False
    if isinstance(kind, zeep.xsd.DateTime):
        return datetime.fromisoformat("2026-01-31T12:00:00+00:00")
    if isinstance(kind, zeep.xsd.Base64Binary):
        return b"nosuchthing"
    if isinstance(kind, zeep.xsd.Int | zeep.xsd.Long | zeep.xsd.Double):
        return 1
    return "nosuchthing"


def _described(api: Api) -> dict[str, tuple[str, str, Json]]:
    """By the names that operations have in SOAP: method, path and parameters of REST."""
    document = api.call("GET", "/../openapi.json").json()
    found = {}
    for path, methods in document["paths"].items():
        for method, one in methods.items():
            name = one.get("x-soap-name", one["operationId"])
            if path.startswith("/api/v1") and "x-without-soap" not in one:
                found[name] = (method, path, one)
    return found


def _made(api: Api, path: str, body: Json) -> str:
    answer = api.call("POST", path, body)
    assert answer.status_code == 201, answer.text
    made: str = answer.json()["id"]
    return made


@pytest.fixture
def things(own_server: Server) -> Iterator[dict[str, str]]:
    """Ids of what there is to look at, by the names of elements."""
    api = Api(own_server.address, own_server.local_key())
    yield {
        "missionId": _made(api, "/missions", MISSION),
        "zoneId": _made(api, "/zones", ZONE),
        "virtualDroneId": _made(api, "/virtual-drones", {"name": "An errand"}),
        "name": "admin",
    }


@pytest.mark.parametrize("version", VERSIONS)
def test_each_operation_answers_or_faults(own_server: Server, version: str) -> None:
    """End to end because zeep makes calls, and reads answers and faults, by the services' own WSDLs."""
    key = own_server.local_key()
    api = Api(own_server.address, key)
    caller = Caller(own_server, key, version)
    commands = {"arm", "takeoff", "goto", "land"}
    assert commands <= caller.names()
    assert caller.names() >= set(_described(api)) - {"giveCommand"}
    for name in sorted(caller.names()):
        try:
            caller.call(name, caller.made(name))
        except zeep.exceptions.Fault as fault:
            assert fault.message, name
            assert fault.code.endswith((":Client", ":Sender")), (name, fault.code, fault.message)


def test_read_operations_match_rest(own_server: Server, things: dict[str, str]) -> None:
    """End to end because zeep reads each member of each answer by the services' own WSDLs."""
    key = own_server.local_key()
    api = Api(own_server.address, key)
    callers = [Caller(own_server, key, version) for version in VERSIONS]
    compared = 0
    for name, (method, path, _) in _described(api).items():
        if method != "get":
            continue
        arguments = {key: value for key, value in things.items() if key in callers[0].made(name)}
        if path.count("{") != len(arguments):
            continue
        address = path
        for value in arguments.values():
            address = address[: address.index("{")] + value + address[address.index("}") + 1 :]
        first = api.call("GET", address.removeprefix("/api/v1"))
        if first.status_code != 200 or "json" not in first.headers["Content-Type"]:
            continue
        answers = [caller.call(name, arguments) for caller in callers]
        last = api.call("GET", address.removeprefix("/api/v1")).json()
        for answer in answers:
            seen: Any = zeep.helpers.serialize_object(answer, dict)  # type: ignore[no-untyped-call]
            if len(first.json()) == 1 and isinstance(seen, dict) and set(seen) == {"item"}:
                # zeep leaves out what stands around the one member of an answer.
                seen = dict.fromkeys(first.json(), seen)
            _same(name, first.json(), last, seen)
        compared += 1
    assert compared > 25


def _same(where: str, first: Any, last: Any, seen: Any) -> None:
    """Compares answers, leaving out what changes between two readings."""
    if isinstance(first, dict) and isinstance(last, dict):
        members = seen or {}
        if set(members) == {"entry"}:
            members = {one["key"]: _content(one) for one in members["entry"]}
        if first.get("type") in members:
            # Which alternative it is is the name of an element in XML.
            members = {"type": first["type"]} | (members[first["type"]] or {})
        for name in first.keys() & last.keys():
            _same(f"{where}.{name}", first[name], last[name], members.get(name))
        more = {name for name, value in members.items() if value is not None and name not in first}
        assert not more or first != last, (where, first, members)
    elif isinstance(first, list) and isinstance(last, list):
        items = (seen or {}).get("item", []) or []
        if len(first) == len(last):
            assert len(items) == len(first), (where, first, seen)
            for before, after, item in zip(first, last, items, strict=True):
                _same(where, before, after, item)
    elif first == last:
        if isinstance(seen, datetime):
            assert seen == datetime.fromisoformat(first), (where, first, seen)
        else:
            assert seen == first, (where, first, seen)


def _content(entry: Json) -> Any:
    if "_value_1" in entry:
        return entry["_value_1"]
    return {name: value for name, value in entry.items() if name != "key"}
