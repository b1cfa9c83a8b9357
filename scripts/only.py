"""Finds the tests whose names match a pattern, for `./dronemap test --only` and `--repeat`.

Usage: only.py test|soak PATTERN PYTHON-PROJECT…

A test has two names: PATH::TEST, and what the report calls it. The pattern is a part of either; `*` in it
stands for any text, nothing else is special, and capital letters count. Of Java, what follows a bracket is
not looked at: all cases of a parametrised test are one. Prints what to run, tab-separated:
  java    MODULE   CLASS, CLASS#METHOD or CLASS#METHOD+METHOD
  vitest  PROJECT  FILE, and a regular expression of names; empty: the whole file
  phpunit TEST
  pytest  PROJECT  node id
The last line on the error output says how many tests match, or why that is not known (exit code 1).
"""

import re
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
NO_TESTS_COLLECTED = 5
SOAK = '@Tag("soak")'
# Only a profile has it, which the long tests alone are run with.
SOAK_MODULE = "dronemap-archive"

JAVA_TEST = re.compile(r"^[ \t]+@(?:Test|ParameterizedTest|RepeatedTest|TestFactory|TestTemplate)\b", re.M)
JAVA_METHOD = re.compile(
    r"^[ \t]+(?:(?:public|protected|static|final) )*(?!return |new |throw )[\w<>\[\], ?.]+ (\w+)\(", re.M
)
JAVA_RULE = re.compile(r"^[ \t]+@ArchTest\s+(?:[\w<>]+\s+)*?(\w+)\s*[=(]", re.M)
JAVA_CLASS = re.compile(
    r"^(?:@.*\s)*(?:public )?((?:abstract |final )*)class (\w+)(?:<[^{]*?>)?(?: extends (\w+))?", re.M
)
ANNOTATIONS_BEFORE = re.compile(r"(?:^[ \t]+@.*\n)*\Z", re.M)

TS_CALL = re.compile(r"^( *)(describe|it|test)((?:\.\w+)*)\(", re.M)
TS_TITLE = re.compile(r"""\s*(['"`])((?:\\.|(?!\1).)*)\1""", re.S)
TS_EACH_TITLE = re.compile(r"""\)\(\s*(['"`])((?:\\.|(?!\1).)*)\1""", re.S)
TS_HOLE = re.compile(r"%[a-zA-Z#]|\$\{[^}]*\}|\$[\w.]+")


class Pattern:
    """A part of a name, in which stars stand for any text."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._expression = re.compile(".*".join(map(re.escape, text.split("*"))), re.S)

    def matches(self, *names: str) -> bool:
        return any(self._expression.search(name) for name in names)

    def without_cases(self) -> "Pattern":
        """Names from reports have the case of a parametrised test behind them."""
        return Pattern(re.split(r"(?<=.)[(\[]", self.text, maxsplit=1)[0])


@dataclass
class Match:
    """So many tests, and the lines that have them run."""

    count: int
    lines: list[str]


# --- Java ---


@dataclass
class JavaClass:
    """A class with tests of its own and of those that it extends; names to whether a test is a long one."""

    path: Path
    package: str
    name: str
    abstract: bool
    parents: list[str]
    soak: bool
    tests: dict[str, bool]
    rules: set[str]

    @property
    def full_name(self) -> str:
        return f"{self.package}.{self.name}"


def java_class(path: Path) -> JavaClass | None:
    text = path.read_text(encoding="utf-8")
    package = re.search(r"^package ([\w.]+);", text, re.M)
    found = next((one for one in JAVA_CLASS.finditer(text) if one[2] == path.stem), None)
    if package is None or found is None:
        return None
    tests: dict[str, bool] = {}
    for test in JAVA_TEST.finditer(text):
        method = JAVA_METHOD.search(text, test.start())
        if method is not None:
            before = ANNOTATIONS_BEFORE.search(text, 0, test.start())
            start = before.start() if before is not None else test.start()
            tests[method[1]] = SOAK in text[start : method.start()]
    rules = {rule[1] for rule in JAVA_RULE.finditer(text)}
    soak = SOAK in text[: found.end()]
    imported = re.findall(rf"^import ([\w.]+\.{found[3]});", text, re.M)
    parents = [*imported, f"{package[1]}.{found[3]}"]
    all_tests = tests | dict.fromkeys(rules, False)
    return JavaClass(path, package[1], path.stem, "abstract" in found[1], parents, soak, all_tests, rules)


def java_lines(root: Path, pattern: Pattern, soak: bool) -> Match:
    folders = [
        path
        for path in sorted(root.glob("dronemap-*/src/test/java"))
        if soak or path.parts[-4] != SOAK_MODULE
    ]
    found = [java_class(path) for folder in folders for path in sorted(folder.rglob("*.java"))]
    classes = {one.full_name: one for one in found if one is not None}
    count, lines = 0, []
    for one in classes.values():
        if one.abstract or not one.name.endswith("Test"):
            continue
        tests, rules = inherited(one, classes)
        names = [name for name, long in tests.items() if long == soak]
        path = one.path.relative_to(root)
        chosen = [name for name in names if pattern.matches(f"{path}::{name}", f"{one.full_name} {name}")]
        if chosen:
            whole = chosen == names or rules & set(chosen)
            count += len(chosen)
            lines.append(f"java\t{path.parts[0]}\t{one.full_name}{'' if whole else '#' + '+'.join(chosen)}")
    return Match(count, lines)


def inherited(one: JavaClass, classes: dict[str, JavaClass]) -> tuple[dict[str, bool], set[str]]:
    """All tests of a class, and which of them are rules that cannot be run singly."""
    line = [one]
    while (parent := next((classes[name] for name in line[-1].parents if name in classes), None)) is not None:
        line.append(parent)
    soak = any(ancestor.soak for ancestor in line)
    tests = {name: long or soak for ancestor in reversed(line) for name, long in ancestor.tests.items()}
    return tests, {rule for ancestor in line for rule in ancestor.rules}


# --- TypeScript ---


def titles(text: str) -> Iterator[list[tuple[str, bool]]]:
    """The titles of each test, the outermost first, and whether they have holes that are filled later."""
    groups: list[tuple[int, str, bool]] = []
    for call in TS_CALL.finditer(text):
        each = ".each" in call[3]
        title = TS_EACH_TITLE.search(text, call.end()) if each else TS_TITLE.match(text, call.end())
        if title is None:
            continue
        indent = len(call[1])
        words = re.sub(r"\\(.)", r"\1", title[2])
        groups = [group for group in groups if group[0] < indent]
        if call[2] == "describe":
            groups.append((indent, words, each or title[1] == "`"))
        else:
            yield [*((name, holes) for _, name, holes in groups), (words, each or title[1] == "`")]


def as_expression(names: list[tuple[str, bool]]) -> str:
    """Name as the test runner has it: all titles with spaces between."""
    parts = [TS_HOLE.split(words) if holes else [words] for words, holes in names]
    return " ".join(
        ".*".join(re.sub(r"([.*+?^${}()|\[\]\\/])", r"\\\1", text) for text in part) for part in parts
    )


TYPESCRIPT_PROJECTS = ("web-client", "sdk-typescript")


def vitest_lines(root: Path, project: str, pattern: Pattern) -> Match:
    client = root / project
    count, lines = 0, []
    for path in sorted(path for folder in ("dev", "src") for path in client.glob(f"{folder}/**/*.test.ts")):
        tests = list(titles(path.read_text(encoding="utf-8")))
        file = path.relative_to(client)
        chosen = []
        for names in tests:
            words = " > ".join(name for name, _ in names)
            if pattern.matches(f"{project}/{file}::{words}", f"{file} {words}"):
                chosen.append(names)
        count += len(chosen)
        if chosen and len(chosen) == len(tests):
            lines.append(f"vitest\t{project}\t{file}\t")
        else:
            lines += [f"vitest\t{project}\t{file}\t{as_expression(names)}" for names in chosen]
    return Match(count, lines)


# --- PHP ---

PHP_TEST = re.compile(r"^    public function (test\w+)\(", re.M)


def phpunit_lines(root: Path, pattern: Pattern) -> Match:
    """Without those that need a server: an end-to-end test runs them."""
    lines = []
    for path in sorted(root.glob("php-soap-proxy/tests/*Test.php")):
        text = path.read_text(encoding="utf-8")
        if "@group server" in text:
            continue
        for test in PHP_TEST.findall(text):
            if pattern.matches(f"{path.relative_to(root)}::{test}", f"{path.stem} {test}"):
                lines.append(f"phpunit\t{test}")
    return Match(len(lines), lines)


# --- Python ---


class CollectionError(Exception):
    """The tests of a project could not be listed."""


def node_ids(folder: Path, soak: bool) -> list[str]:
    options = [
        "--collect-only",
        "-q",
        "-n",
        "0",
        "-m",
        "soak" if soak else "not soak",
        "-p",
        "no:cacheprovider",
    ]
    outcome = subprocess.run(
        [sys.executable, "-m", "pytest", *options], cwd=folder, text=True, capture_output=True, check=False
    )
    if outcome.returncode not in (0, NO_TESTS_COLLECTED):
        print(outcome.stdout, outcome.stderr, file=sys.stderr)
        raise CollectionError(f"The tests of {folder.name} cannot be listed.")
    return [line for line in outcome.stdout.splitlines() if re.match(r"[^ ]+\.py::", line)]


def pytest_lines(root: Path, project: str, pattern: Pattern, soak: bool) -> Match:
    lines = []
    for test in node_ids(root / project, soak):
        path, _, name = test.partition("::")
        group, _, last = name.rpartition("::") if "[" not in name else ("", "", name)
        shown = ".".join([path.removesuffix(".py").replace("/", "."), *filter(None, [group])])
        if pattern.matches(f"{project}/{test}", f"{shown} {last}"):
            lines.append(f"pytest\t{project}\t{test}")
    return Match(len(lines), lines)


def matches(root: Path, soak: bool, pattern: Pattern, projects: list[str]) -> list[Match]:
    with ThreadPoolExecutor(2) as threads:
        python = threads.map(lambda project: pytest_lines(root, project, pattern, soak), projects)
        rest = [java_lines(root, pattern.without_cases(), soak)]
        if not soak:
            rest.append(phpunit_lines(root, pattern.without_cases()))
            rest.extend(vitest_lines(root, project, pattern) for project in TYPESCRIPT_PROJECTS)
        return [*rest, *python]


def main(arguments: list[str], root: Path = ROOT) -> int:
    kind, pattern, *projects = arguments
    try:
        found = matches(root, kind == "soak", Pattern(pattern), projects)
    except CollectionError as reason:
        print(reason, file=sys.stderr)
        return 1
    for line in (line for match in found for line in match.lines):
        print(line)
    count = sum(match.count for match in found)
    print(f"{count} {'test matches' if count == 1 else 'tests match'} '{pattern}'", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
