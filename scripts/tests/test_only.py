"""Finding tests by a pattern, in every language."""

from pathlib import Path

import pytest

import only

CONTRACT = """package org.a;

abstract class StoreContract {
    @Test
    void keepsWhatItWasGiven() {}

    @Test
    @Tag("soak")
    void keepsItForLong() {}
}
"""
STORE = """package org.a;

class FileStoreTest extends StoreContract {
    @ParameterizedTest
    @CsvSource({
        "a, isNoTest(1)",
    })
    void readsFiles(String name) {
        return helper(name);
    }

    @Tag("soak")
    @Test
    void readsManyFiles() {}

    void helper(String name) {}
}
"""
RULES = """package org.a;

class ShapeTest {
    @ArchTest
    static final ArchRule arrows = classes();

    @Test
    void isRound() {}
}
"""
LONG = """package org.b;

/** All of it. */
@Tag("soak")
final class LongTest {
    @Test
    void lasts() {}
}
"""
WEB = """import { describe, it } from 'vitest';

describe('a run', () => {
  describe('on the map', () => {
    it('shows (all) it\\'s places', () => {
      expect('no test').toBe(`it('is none')`);
    });
  });
  it.each([
    ['a', 1],
    ['b', 2],
  ])('counts %s as $count', (name, count) => {});
});

it(`stands ${alone} here`, () => {});
"""
PYTHON = """import pytest

@pytest.mark.parametrize("what", ["a b", "c"])
def test_flies(what): pass

class TestGroup:
    def test_lands(self): pass

@pytest.mark.soak
def test_lasts(): pass
"""

PHP = """<?php
final class AirTest extends TestCase
{
    public function testThins(): void
    {
    }

    public function levels(): array
    {
    }
}
"""


def written(folder: Path) -> Path:
    files = {
        "dronemap-a/src/test/java/org/a/StoreContract.java": CONTRACT,
        "dronemap-a/src/test/java/org/a/FileStoreTest.java": STORE,
        "dronemap-a/src/test/java/org/a/ShapeTest.java": RULES,
        "dronemap-b/src/test/java/org/b/LongTest.java": LONG,
        "web-client/src/runs/run.test.ts": WEB,
        "web-client/dev/play.test.ts": "it('plays', () => undefined);",
        "sdk-typescript/src/hear.test.ts": "it('hears', () => undefined);",
        "php-soap-proxy/tests/AirTest.php": PHP,
        "php-soap-proxy/tests/WholeTest.php": PHP.replace("<?php", "<?php /** @group server */"),
        "snake/tests/test_air.py": PYTHON,
        "snake/pyproject.toml": '[tool.pytest.ini_options]\nmarkers = ["soak"]\n',
    }
    for name, text in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return folder


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return written(tmp_path)


@pytest.fixture(scope="module")
def listed(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """By pytest itself, once: that takes a second or two."""
    return only.node_ids(written(tmp_path_factory.mktemp("once")) / "snake", soak=False)


def found(
    root: Path, pattern: str, kind: str, capsys: pytest.CaptureFixture[str], *projects: str
) -> list[str]:
    assert only.main([kind, pattern, *projects], root) == 0
    return [line.replace("\t", " ") for line in capsys.readouterr().out.splitlines()]


FILE_STORE, SHAPE = "java dronemap-a org.a.FileStoreTest", "java dronemap-a org.a.ShapeTest"


@pytest.mark.parametrize(
    ("pattern", "expected"),
    [
        ("FileStoreTest", [FILE_STORE]),
        ("dronemap-a/src/test/java/org/a/FileStoreTest.java::readsFiles", [f"{FILE_STORE}#readsFiles"]),
        ("org.a.FileStoreTest readsFiles(String)[1]", [f"{FILE_STORE}#readsFiles"]),
        ("keepsWhat", [f"{FILE_STORE}#keepsWhatItWasGiven"]),
        ("File*Given", [f"{FILE_STORE}#keepsWhatItWasGiven"]),
        ("filestoretest", []),
        ("helper", []),
        ("isNoTest", []),
        ("LongTest", []),
        ("isRound", [f"{SHAPE}#isRound"]),
        ("arrows", [SHAPE]),
    ],
)
def test_java_is_found_by_file_class_and_method(
    pattern: str, expected: list[str], root: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert found(root, pattern, "test", capsys) == expected


@pytest.mark.parametrize(
    ("pattern", "expected"),
    [
        ("LongTest", ["java dronemap-b org.b.LongTest"]),
        ("dronemap-a", [FILE_STORE]),
        ("reads", [f"{FILE_STORE}#readsManyFiles"]),
        ("a run", []),
    ],
)
def test_long_java_tests_are_found_for_soak_only(
    pattern: str, expected: list[str], root: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert found(root, pattern, "soak", capsys) == expected


MAP, COUNTS = r"a run on the map shows \(all\) it's places", "a run counts .* as .*"


def test_typescript_is_found_beside_the_page(root: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert found(root, "plays", "test", capsys) == ["vitest web-client dev/play.test.ts "]
    assert found(root, "sdk-typescript/src/hear.test.ts::", "test", capsys) == [
        "vitest sdk-typescript src/hear.test.ts "
    ]


@pytest.mark.parametrize(
    "pattern", ["AirTest.php::testThins", "AirTest", "php-soap-proxy/", "Test testThins"]
)
def test_php_is_found_where_it_needs_no_server(
    pattern: str, root: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert found(root, pattern, "test", capsys) == ["phpunit testThins"]
    assert found(root, "levels", "test", capsys) == []


@pytest.mark.parametrize(
    ("pattern", "expected"),
    [
        ("run.test.ts", [""]),
        ("on the map", [MAP]),
        ("src/runs/run.test.ts a run > on the map > shows", [MAP]),
        ("counts", [COUNTS]),
        ("web-client/src/runs/run.test.ts::a run > ", [MAP, COUNTS]),
        ("stands", ["stands .* here"]),
        ("is none", []),
        ("no test", []),
    ],
)
def test_typescript_is_found_by_file_and_titles(
    pattern: str, expected: list[str], root: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert found(root, pattern, "test", capsys) == [
        f"vitest web-client src/runs/run.test.ts {name}" for name in expected
    ]


@pytest.mark.parametrize(
    ("pattern", "expected"),
    [
        ("snake/tests/test_air.py::", ["test_flies[a b]", "test_flies[c]", "TestGroup::test_lands"]),
        ("flies[c]", ["test_flies[c]"]),
        ("test_flies[a b]", ["test_flies[a b]"]),
        ("tests.test_air test_flies[c]", ["test_flies[c]"]),
        ("tests.test_air.TestGroup test_lands", ["TestGroup::test_lands"]),
        ("[", ["test_flies[a b]", "test_flies[c]"]),
        ("test_lasts", []),
    ],
)
def test_python_is_found_by_file_name_and_case(
    pattern: str,
    expected: list[str],
    listed: list[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(only, "node_ids", lambda folder, soak: listed)
    assert found(tmp_path, pattern, "test", capsys, "snake") == [
        f"pytest snake tests/test_air.py::{name}" for name in expected
    ]


def test_long_python_tests_are_found_for_soak_only(root: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert found(root, "test_air", "soak", capsys, "snake") == ["pytest snake tests/test_air.py::test_lasts"]


def test_java_classes_of_same_name_in_other_packages(root: Path, capsys: pytest.CaptureFixture[str]) -> None:
    other = root / "dronemap-b/src/test/java/org/b/FileStoreTest.java"
    other.write_text(
        """package org.b;

import org.a.StoreContract;

class FileStoreTest extends StoreContract {}
"""
    )
    same = root / "dronemap-b/src/test/java/org/b/StoreContract.java"
    same.write_text(LONG.replace("LongTest", "StoreContract"))
    assert found(root, "keepsWhat", "test", capsys) == [
        f"{FILE_STORE}#keepsWhatItWasGiven",
        "java dronemap-b org.b.FileStoreTest",
    ]


def test_number_of_matches_is_printed(root: Path, capsys: pytest.CaptureFixture[str]) -> None:
    only.main(["test", "flies", "snake"], root)
    assert capsys.readouterr().err.splitlines()[-1] == "2 tests match 'flies'"
    only.main(["test", "flies[c]", "snake"], root)
    assert capsys.readouterr().err.splitlines()[-1] == "1 test matches 'flies[c]'"


def test_uncollectable_project_is_reported(root: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (root / "snake/tests/test_broken.py").write_text("import nothing_like_this")
    assert only.main(["test", "flies", "snake"], root) == 1
    assert capsys.readouterr().err.splitlines()[-1] == "The tests of snake cannot be listed."


def test_every_java_test_of_this_checkout_is_found() -> None:
    """The listing reads sources; a way to write a test that it does not know must not hide one."""
    listed = only.java_lines(only.ROOT, only.Pattern(""), soak=False).lines
    classes = {line.split("\t")[2] for line in listed}
    long = {line.split("\t")[2] for line in only.java_lines(only.ROOT, only.Pattern(""), soak=True).lines}
    for file in only.ROOT.glob("dronemap-*/src/test/java/**/*Test.java"):
        text = file.read_text()
        if "abstract class " in text or "dronemap-archive" in str(file):
            continue
        name = ".".join(file.with_suffix("").parts[file.parts.index("java") + 1 :])
        assert name in classes | long, name
