"""A status that REST's description lists must have been seen by a test, or have a reason."""

import json
from pathlib import Path

import pytest

import listed_statuses

from .conftest import ROOT

DESCRIPTION = {
    "paths": {
        "/api/drones": {"get": {"responses": {"200": {}}}, "parameters": []},
        "/api/drones/{id}": {"get": {"responses": {"200": {}, "404": {}}}},
        "/api/drones/lost": {"get": {"responses": {"200": {}}}},
    }
}
ALL_SEEN = [
    "GET /api/drones 200",
    "GET /api/drones/drone-1 200",
    "GET /api/drones/{id} 404",
    "GET /api/drones/lost 200",
]


class StatusCheck:
    def __init__(self, folder: Path, printed: pytest.CaptureFixture[str]) -> None:
        self.folder = folder
        self.printed = printed
        self.exceptions = ""
        (folder / "seen").mkdir()

    def record(self, *lines: str, by: str = "1") -> None:
        (self.folder / "seen" / f"{by}.txt").write_text("".join(f"{line}\n" for line in lines))

    def check(self) -> tuple[int, list[str]]:
        """The exit code, and what is printed."""
        description, exceptions = self.folder / "openapi.json", self.folder / "exceptions.txt"
        description.write_text(json.dumps(DESCRIPTION))
        exceptions.write_text(self.exceptions)
        code = listed_statuses.main([str(description), str(exceptions), str(self.folder / "seen")])
        return code, [line for line in self.printed.readouterr().out.splitlines() if line]


@pytest.fixture
def status_check(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> StatusCheck:
    return StatusCheck(tmp_path, capsys)


def test_all_listed_statuses_seen_passes(status_check: StatusCheck) -> None:
    status_check.record(*ALL_SEEN[:2], by="1")
    status_check.record(*ALL_SEEN[2:], by="end-to-end-7")
    assert status_check.check() == (0, ["4 statuses are listed, 4 of them were seen."])


def test_unseen_statuses_are_named(status_check: StatusCheck) -> None:
    status_check.record("GET /api/drones 200")
    code, printed = status_check.check()
    assert code == 1
    assert printed[:-1] == [
        "GET /api/drones/lost lists 200, and no test has seen it answer that.",
        "GET /api/drones/{id} lists 200, and no test has seen it answer that.",
        "GET /api/drones/{id} lists 404, and no test has seen it answer that.",
    ]


def test_unlisted_statuses_are_named(status_check: StatusCheck) -> None:
    status_check.record(*ALL_SEEN, "GET /api/drones/drone-1 500")
    code, printed = status_check.check()
    assert code == 1
    assert printed[0] == "GET /api/drones/{id} was seen to answer 500, and does not list that."


def test_literal_path_wins_over_template(status_check: StatusCheck) -> None:
    status_check.record(*ALL_SEEN[:1], *ALL_SEEN[2:])
    assert (
        status_check.check()[1][0] == "GET /api/drones/{id} lists 200, and no test has seen it answer that."
    )


def test_unknown_paths_are_ignored(status_check: StatusCheck) -> None:
    status_check.record(*ALL_SEEN, "GET /nowhere 404", "POST /api/drones 405", "GET /api/drones/a/b 404")
    assert status_check.check()[0] == 0


def test_exceptions_count_as_seen(status_check: StatusCheck) -> None:
    status_check.record(*ALL_SEEN[1:])
    status_check.exceptions = "# why\n\nGET /api/drones 200: nobody has drones\n"
    assert status_check.check()[0] == 0


def test_needless_exception_is_refused(status_check: StatusCheck) -> None:
    status_check.record(*ALL_SEEN)
    status_check.exceptions = "GET /api/drones 200: never\nGET /api/drones 507: no disk is that full\n"
    code, printed = status_check.check()
    assert code == 1
    assert printed[:-1] == [
        "GET /api/drones 200 is an exception, but a test has seen it: strike it from the exceptions.",
        "GET /api/drones 507 is an exception, but not in the description: strike it from the exceptions.",
    ]


@pytest.mark.parametrize("line", ["GET /api/drones 200", "GET /api/drones 200: ", "/api/drones 200: never"])
def test_an_exception_without_a_reason_is_refused(status_check: StatusCheck, line: str) -> None:
    status_check.record(*ALL_SEEN)
    status_check.exceptions = f"{line}\n"
    with pytest.raises(SystemExit, match="is not METHOD PATTERN STATUS: why no test can see it"):
        status_check.check()


def test_run_without_seen_statuses_fails(status_check: StatusCheck) -> None:
    status_check.record()
    code, printed = status_check.check()
    assert code == 1
    assert len(printed) == 1 and printed[0].startswith("No test has written down in ")


def test_rest_description_of_this_checkout_is_read() -> None:
    wire = ROOT / "dronemap-ws" / "src" / "test" / "resources" / "wire" / "openapi.json"
    description = listed_statuses.Description(wire)
    assert len(description.listed) > 1000
    assert description.pattern("GET", "/api/v1/drones/drone-1") == "/api/v1/drones/{id}"
