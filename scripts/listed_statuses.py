"""Holds the statuses that the description of REST lists against those that tests have seen.

Arguments: the description (OpenAPI), the list of exceptions, the folder with what was seen.
Each file there has lines
    METHOD PATH STATUS
where PATH is an address or the description's pattern of it; what the description does not have is
passed over. A line of the list of exceptions is
    METHOD PATTERN STATUS: why no test can see it
Prints a sentence for each status that is listed, and that no test has seen; for each that was seen,
and is not listed; and for each exception that is none. Exit code 1 when there is any.
"""

import argparse
import json
import re
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

METHODS = {"get", "put", "post", "delete", "patch", "head", "options", "trace"}
EXCEPTION = re.compile(r"([A-Z]+) (/\S*) ([1-5]\d\d): (\S.*)")


@dataclass(frozen=True, order=True)
class Listed:
    """An operation, by its method and the pattern of its address, and one of its statuses."""

    pattern: str
    method: str
    status: int

    def __str__(self) -> str:
        return f"{self.method} {self.pattern} {self.status}"


class Description:
    """Operations of the description, and the statuses that each answers with."""

    def __init__(self, file: Path) -> None:
        self.listed: set[Listed] = set()
        self._patterns: dict[str, list[tuple[re.Pattern[str], str]]] = {}
        self._known: dict[tuple[str, str], str | None] = {}
        paths = json.loads(file.read_text(encoding="utf-8"))["paths"]
        # What is written out goes before what stands for anything.
        for pattern in sorted(paths, key=lambda each: each.count("{")):
            address = re.compile(re.sub(r"\\{[^/]+?\\}", "[^/]+", re.escape(pattern)))
            for method in METHODS & paths[pattern].keys():
                name = method.upper()
                self._patterns.setdefault(name, []).append((address, pattern))
                for status in paths[pattern][method]["responses"]:
                    self.listed.add(Listed(pattern, name, int(status)))

    def pattern(self, method: str, address: str) -> str | None:
        """Pattern of the operation that an address belongs to; None: there is none."""
        key = (method, address)
        if key not in self._known:
            found = (pattern for each, pattern in self._patterns.get(method, []) if each.fullmatch(address))
            self._known[key] = next(found, None)
        return self._known[key]


def read_seen(folder: Path, description: Description) -> Iterator[Listed]:
    for file in sorted(folder.glob("*.txt")):
        for line in file.read_text(encoding="utf-8").splitlines():
            method, address, status = line.split(" ")
            pattern = description.pattern(method, address)
            if pattern:
                yield Listed(pattern, method, int(status))


def read_exceptions(file: Path) -> set[Listed]:
    exceptions: set[Listed] = set()
    for line in file.read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            found = EXCEPTION.fullmatch(line)
            if not found:
                raise SystemExit(f"{file}: '{line}' is not METHOD PATTERN STATUS: why no test can see it")
            method, pattern, status, _ = found.groups()
            exceptions.add(Listed(pattern, method, int(status)))
    return exceptions


def differences(listed: set[Listed], exceptions: set[Listed], seen: set[Listed]) -> Iterable[str]:
    for one in sorted(listed - seen - exceptions):
        yield f"{one.method} {one.pattern} lists {one.status}, and no test has seen it answer that."
    for one in sorted(seen - listed):
        yield f"{one.method} {one.pattern} was seen to answer {one.status}, and does not list that."
    for one in sorted(exceptions & seen):
        yield f"{one} is an exception, but a test has seen it: strike it from the exceptions."
    for one in sorted(exceptions - listed):
        yield f"{one} is an exception, but not in the description: strike it from the exceptions."


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description="Tells which statuses of REST are listed and never seen.")
    parser.add_argument("description", type=Path)
    parser.add_argument("exceptions", type=Path)
    parser.add_argument("seen", type=Path)
    chosen = parser.parse_args(arguments)
    description = Description(chosen.description)
    seen = set(read_seen(chosen.seen, description))
    if not seen:
        print(f"No test has written down in {chosen.seen} with which statuses REST answers.")
        return 1
    wrong = list(differences(description.listed, read_exceptions(chosen.exceptions), seen))
    print(*wrong, sep="\n")
    print(
        f"{len(description.listed)} statuses are listed, {len(seen & description.listed)} of them were seen."
    )
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
