"""What an operation of REST is called in SOAP and in the two clients."""

import ast
import re
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

from .wsdl import Service

COMMAND = re.compile(r"^Give a command \(\w+\): (\w+)$")
TYPESCRIPT = re.compile(r"^  (\w+)(\(.*\): Promise<.*>);$", re.MULTILINE)


@dataclass
class Faces:
    services: list[Service]
    python: dict[str, str]
    typescript: dict[str, str]
    # Methods of a drone in the Python client.
    drone_methods: set[str]

    @classmethod
    def read(cls, root: Path, wire: Path) -> "Faces":
        services = [
            Service.of(ElementTree.parse(file).getroot()) for file in sorted((root / wire / "wsdl").glob("*.wsdl"))
        ]
        contract = (root / "sdk-python/dronemap/contract/operations.py").read_text(encoding="utf-8")
        drone = (root / "sdk-python/dronemap/drone.py").read_text(encoding="utf-8")
        typescript = (root / "sdk-typescript/src/contract/operations.ts").read_text(encoding="utf-8")
        return cls(
            services,
            _python_calls(contract),
            {name: f"{name}{rest}" for name, rest in TYPESCRIPT.findall(typescript)},
            set(re.findall(r"^    async def ([a-z]\w*)\(", drone, re.MULTILINE)),
        )

    def soap(self, name: str) -> list[str]:
        """The services that have an operation of this name."""
        return [service.name for service in self.services if name in service.operations]

    def soap_commands(self) -> dict[str, tuple[str, str]]:
        """By type of command: service and operation."""
        return {
            found[1]: (service.name, name)
            for service in self.services
            for name, operation in service.operations.items()
            if (found := COMMAND.match(operation.about))
        }


def _python_calls(text: str) -> dict[str, str]:
    """By id of the operation, the call as one writes it."""
    calls = {}
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.AsyncFunctionDef):
            ids = [
                inner.args[0].value
                for inner in ast.walk(node)
                if isinstance(inner, ast.Call) and getattr(inner.func, "id", "") == "Call"
                if isinstance(inner.args[0], ast.Constant)
            ]
            if ids:
                node.args.args.pop(0)
                calls[str(ids[0])] = f"{node.name}({ast.unparse(node.args)}) -> {ast.unparse(node.returns or node)}"
    return calls
