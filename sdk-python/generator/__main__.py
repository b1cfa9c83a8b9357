"""python -m generator [--check]: writes, or compares, what follows from the description of REST."""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from generator.openness import in_pythons_way, opened, without_bounds
from generator.operations import awaited, operations_of, plain

ROOT = Path(__file__).resolve().parents[1]
DESCRIPTION = ROOT.parent / "dronemap-ws" / "src" / "test" / "resources" / "wire" / "openapi.json"
_HEAD = '''"""What a server answers and takes, and what of it is null when nobody knows it.

Written from the description of REST by `python -m generator`.
"""

# ruff: noqa: E501
'''


def models(description: dict[str, object]) -> str:
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder) / "openapi.json", Path(folder) / "models.py"
        source.write_text(json.dumps(description))
        subprocess.run(
            [
                Path(sys.executable).with_name("datamodel-codegen"),
                *("--input", source, "--input-file-type", "openapi", "--output", target),
                *(
                    "--output-model-type",
                    "pydantic_v2.BaseModel",
                    "--base-class",
                    "dronemap.contract.model.Model",
                ),
                *("--target-python-version", "3.11", "--formatters", "builtin", "--use-annotated"),
                *("--snake-case-field", "--enum-field-as-literal", "all", "--use-one-literal-as-default"),
                *("--use-schema-description", "--use-field-description", "--use-union-operator"),
                *("--use-type-alias", "--union-mode", "left_to_right", "--disable-timestamp"),
            ],
            check=True,
        )
        return _HEAD + _tidied(target.read_text())


def _tidied(text: str) -> str:
    """Where only one alternative can fit, the order in which they are tried need not be told; no list is null."""
    text = re.sub(
        r"Annotated\[\s*(list\[\w+\]) \| None,\s*Field\(validate_default=True\),?\s*\] = \[\]", r"\1 = []", text
    )
    text = re.sub(r"(: list\[.*\]) \| None = \[\]\n", r"\1 = []\n", text)
    text = text.replace("| dict[str, Any],\n        Field(union_mode", "| UnknownKind,\n        Field(union_mode")
    text = re.sub(
        r"(\n    \w+: )Annotated\[\s*((?:(?!Field\()[^#])+?),\s*Field\(union_mode='left_to_right'\),?\s*\]",
        r"\1\2",
        text,
    )
    return text.replace("import Model\n", "import Model, UnknownKind\n", 1)


def formatted(text: str) -> str:
    ruff = str(Path(sys.executable).with_name("ruff"))
    name = ["--stdin-filename", "dronemap/contract/models.py", "-"]
    for command in (["check", "--quiet", "--fix-only", "--select", "I,F401,UP", *name], ["format", *name]):
        done = subprocess.run([ruff, *command], input=text, text=True, check=True, capture_output=True, cwd=ROOT)
        text = done.stdout
    return text


def written() -> dict[Path, str]:
    """The files, and what is in them."""
    description = json.loads(DESCRIPTION.read_text())
    operations = operations_of(description)
    package = ROOT / "dronemap"
    return {
        package / "contract" / "models.py": formatted(models(in_pythons_way(opened(without_bounds(description))))),
        package / "contract" / "operations.py": formatted(awaited(operations)),
        package / "sync" / "operations.py": formatted(plain(operations)),
    }


def main(arguments: list[str]) -> int:
    differing = [path for path, text in written().items() if not path.exists() or path.read_text() != text]
    if arguments == ["--check"]:
        for path in differing:
            print(
                f"{path.relative_to(ROOT)} is not what the description gives: python -m generator",
                file=sys.stderr,
            )
        return min(1, len(differing))
    for path, text in written().items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
