"""Each command of each group: what it asks, what it prints, and how it ends when the server refuses."""

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import contract_samples as samples
import pytest
from fake_server import FakeServer, command, drone, problem, run

MISSION = json.dumps(samples.ITEMS)
FILES = {
    "mission.json": MISSION,
    "waypoints.json": '[{"latitude": 47.1, "longitude": 8.1, "altitude": 15, "id": "tower"}]',
    "zones.geojson": json.dumps(samples.ZONES),
    "zones.kml": "<kml/>",
    "some.param": "RTL_ALT 1800\n",
}


@dataclass(frozen=True)
class Case:
    """A command line, the request that it is there for, what that is answered with, and words for people."""

    line: str
    asks: str
    answer: Any
    says: str
    body: Any = None
    before: dict[str, Any] = field(default_factory=dict)

    def __str__(self) -> str:
        return self.line


MISSIONS = {"GET /missions": {"missions": [samples.SAVED]}}
ZONES = {"GET /zones": samples.ZONES}
VIRTUALS = {"GET /virtual-drones": {"virtualDrones": [samples.VIRTUAL]}}
DONE = command("setParameters")
CASES = [
    Case("drones", "GET /drones", None, "Heron-1"),
    Case("events list", "GET /drones/d1/events", samples.EVENTS, "Armed."),
    Case("mission list", "GET /missions", MISSIONS["GET /missions"], "round"),
    Case("mission show round", "GET /missions", MISSIONS["GET /missions"], "10 m above home"),
    Case("mission save mission.json round", "POST /missions", samples.SAVED, "round", {"items": samples.ITEMS}),
    Case("mission delete round --yes", "DELETE /missions/m1", None, "deleted", None, MISSIONS),
    Case("plan make waypoints.json -d Heron-1", "POST /plans", samples.PLAN, "tower", {"drones": ["d1"]}),
    Case("plan list", "GET /plans", {"plans": [samples.PLAN]}, "finished"),
    Case("plan show p1", "GET /plans/p1", samples.PLAN, "Heron-1"),
    Case("plan accept p1 --start", "POST /plans/p1/accept", samples.PLAN, "DRONE", {"start": True}),
    Case(
        "plan run p1 --no-wait --ask-first",
        "POST /runs",
        samples.RUN,
        "started",
        {"plan": "p1", "mode": "askFirst"},
        {"GET /plans/p1": samples.PLAN},
    ),
    Case("plan run p1", "POST /runs", samples.RUN, "1 of 1", None, {"GET /plans/p1": samples.PLAN}),
    Case("plan delete p1 --yes", "DELETE /plans/p1", None, "deleted"),
    Case("run list", "GET /runs", {"runs": [samples.RUN]}, "1/1"),
    Case("run show r1", "GET /runs/r1", samples.RUN, "landed"),
    Case("run watch r1", "GET /runs/r1", samples.RUN, "One drone sets off."),
    Case("run pause r1", "POST /runs/r1/pause", samples.RUN, "Tour"),
    Case("run continue r1", "POST /runs/r1/continue", samples.RUN, "Tour"),
    Case("run stop r1", "POST /runs/r1/stop", samples.RUN, "Tour"),
    Case(
        "send -33.5 -70.5 --height 40 --no-wait",
        "POST /dispatches",
        samples.DISPATCH,
        "Heron-1 was chosen.",
        {"latitude": -33.5, "longitude": -70.5, "height": 40},
    ),
    Case(
        "return --all --yes --no-wait",
        "POST /recoveries",
        samples.RECOVERY,
        "stopping",
        {"manner": "return"},
        {"POST /recoveries/preview": samples.RECOVERY_PREVIEW},
    ),
    Case(
        "land --all --yes --no-wait",
        "POST /recoveries",
        samples.RECOVERY,
        "stopping",
        {"manner": "land"},
        {"POST /recoveries/preview": samples.RECOVERY_PREVIEW},
    ),
    Case("recovery list", "GET /recoveries", {"recoveries": [samples.RECOVERY]}, "stopping"),
    Case("recovery cancel c1", "POST /recoveries/c1/cancel", samples.RECOVERY, "c1"),
    Case("dispatch list", "GET /dispatches", {"dispatches": [samples.DISPATCH]}, "chosen"),
    Case("dispatch cancel s1", "POST /dispatches/s1/cancel", samples.DISPATCH, "Heron-1"),
    Case("follow list", "GET /follows", {"follows": [samples.FOLLOW]}, "allocated"),
    Case(
        "follow open -33.5 -70.5 --side orbit --turn -5",
        "POST /follows",
        samples.FOLLOW,
        "Heron-1 was chosen.",
        {"latitude": -33.5, "longitude": -70.5, "place": {"side": "orbit", "turn": -5.0}},
    ),
    Case("follow start f1", "POST /follows/f1/start", samples.FOLLOW, "Walk"),
    Case(
        "follow report f1 -33.5 8",
        "POST /follows/f1/positions",
        samples.RECEIPT,
        "1 taken",
        None,
        {"GET /follows/f1": samples.FOLLOW},
    ),
    Case("follow pause f1", "POST /follows/f1/pause", samples.FOLLOW, "Walk"),
    Case("follow continue f1", "POST /follows/f1/continue", samples.FOLLOW, "Walk"),
    Case("follow stop f1", "POST /follows/f1/stop", samples.FOLLOW, "Walk"),
    Case("follow cancel f1", "POST /follows/f1/cancel", samples.FOLLOW, "Walk"),
    Case("virtual list", "GET /virtual-drones", VIRTUALS["GET /virtual-drones"], "Done"),
    Case("virtual add survey mission.json", "POST /virtual-drones", samples.VIRTUAL, "v1", {"items": samples.ITEMS}),
    Case(
        "virtual add survey mission.json --up-to 3",
        "POST /virtual-drones",
        samples.VIRTUAL,
        "v1",
        {"items": samples.ITEMS, "upTo": 3},
    ),
    Case("virtual start survey", "POST /virtual-drones/v1/start", samples.VIRTUAL, "Done", None, VIRTUALS),
    Case("virtual start v1 --no-wait", "POST /virtual-drones/v1/start", samples.VIRTUAL, "Done", None, VIRTUALS),
    Case("virtual stop survey", "POST /virtual-drones/v1/stop", samples.VIRTUAL, "Done", None, VIRTUALS),
    Case("virtual continue survey", "POST /virtual-drones/v1/resume", samples.VIRTUAL, "Done", None, VIRTUALS),
    Case("virtual remove survey --yes", "DELETE /virtual-drones/v1", None, "removed", None, VIRTUALS),
    Case("virtual watch survey", "GET /virtual-drones/v1", samples.VIRTUAL, "Done", None, VIRTUALS),
    Case("zones list", "GET /zones", samples.ZONES, "circle of 20 m"),
    Case("zones show mast", "GET /zones", samples.ZONES, '"radius": 20.0'),
    Case("zones import zones.geojson", "POST /zones/import", samples.IMPORTED, "1 zones added: mast."),
    Case("zones import zones.kml", "POST /zones/import", samples.IMPORTED, "road (features[1]): A line is no area."),
    Case("zones delete mast --yes", "DELETE /zones/z1", None, "deleted", None, ZONES),
    Case("params list RTL", "GET /drones/d1/parameters", samples.PARAMETERS, "1500"),
    Case("params get rtl_alt", "GET /drones/d1/parameters", samples.PARAMETERS, "1500"),
    Case("params set RTL_ALT -5", "PUT /drones/d1/parameters/RTL_ALT", DONE, "done", {"value": -5.0}),
    Case(
        "params save -",
        "GET /drones/d1/parameters/file",
        b"RTL_ALT 1500\n",
        "RTL_ALT 1500",
        None,
        {"GET /drones/d1/parameters": samples.PARAMETERS},
    ),
    Case(
        "params diff some.param",
        "POST /drones/d1/parameters/file",
        samples.DIFFERENCE,
        "1 differ, 3 are the same, 1 are unknown to the vehicle.",
        None,
        {"GET /drones/d1/parameters": samples.PARAMETERS},
    ),
    Case(
        "params load some.param --yes",
        "POST /drones/d1/parameters/file",
        samples.DIFFERENCE,
        "They are changed",
        None,
        {"GET /drones/d1/parameters": samples.PARAMETERS},
    ),
    Case("logs list", "GET /drones/d1/logs", samples.LOGS, "2026"),
    Case(
        "logs read",
        "POST /drones/d1/logs/refresh",
        command("readLogs"),
        "2026",
        None,
        {"GET /drones/d1/logs": samples.LOGS},
    ),
    Case("logs delete 1 --yes", "DELETE /drones/d1/logs/1/file", None, "deleted"),
    Case("record list", "GET /recordings", samples.RECORDINGS, "complete"),
    Case("record replay r1 --speed 2", "POST /recordings/r1/replays", samples.REPLAY, "r1.tlog"),
    Case("record delete r1 --yes", "DELETE /recordings/r1", None, "deleted"),
    Case("users list", "GET /users", {"users": [samples.USER]}, "tom"),
    Case("users add tom viewer", "POST /users", samples.USER, "tom: viewer", {"name": "tom", "role": "viewer"}),
    Case("users role tom viewer", "PATCH /users/tom", samples.USER, "tom: viewer", {"role": "viewer"}),
    Case("users enable tom", "PATCH /users/tom", samples.USER, "active", {"state": "active"}),
    Case("users disable tom", "PATCH /users/tom", samples.USER, "tom", {"state": "disabled"}),
    Case("users delete tom --yes", "DELETE /users/tom", None, "deleted"),
    Case("users reset-password tom --yes", "POST /users/tom/password", {"name": "tom", "password": "once"}, "once"),
    Case("keys list", "GET /access-keys", {"accessKeys": [samples.KEY]}, "CI"),
    Case(
        "keys make CI --role viewer --days 3 -d Heron-1 --operation view",
        "POST /access-keys",
        samples.KEY | {"key": "secret"},
        "secret",
        {"label": "CI", "role": "viewer", "days": 3, "drones": ["d1"], "operations": ["view"]},
    ),
    Case("keys renew k1", "POST /access-keys/k1/renew", samples.KEY | {"key": "secret"}, "secret"),
    Case("keys delete k1 --yes", "DELETE /access-keys/k1", None, "deleted"),
]


@pytest.fixture
def server(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> FakeServer:
    for name, text in FILES.items():
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    server = FakeServer(drones=[drone()])
    # What is looked at again while it goes on.
    server.answers["GET /plans/p1"] = samples.PLAN
    server.answers["GET /runs/r1"] = samples.RUN
    server.answers["GET /virtual-drones/v1"] = samples.VIRTUAL
    return server


def prepared(server: FakeServer, case: Case) -> None:
    server.answers |= case.before
    if case.answer is not None or case.asks.startswith("DELETE"):
        server.answers[case.asks] = case.answer


@pytest.mark.parametrize("case", CASES, ids=str)
def test_asks_the_server_and_tells_what_came_of_it(server: FakeServer, case: Case) -> None:
    prepared(server, case)
    result = run(server, *case.line.split())
    assert result.exit_code == 0, result.stderr
    assert case.says in result.stdout
    asked = server.last(*case.asks.split())
    for name, value in (case.body or {}).items():
        assert asked.body[name] == value


@pytest.mark.parametrize("case", CASES, ids=str)
def test_refusal_ends_with_one_sentence_and_its_code(server: FakeServer, case: Case) -> None:
    server.answers |= case.before
    server.answers[case.asks] = lambda asked: problem(403, "Your role may not do that.", "role-too-low")
    result = run(server, *case.line.split())
    assert result.exit_code == 1
    assert result.stderr == "dronectl: Your role may not do that. [role-too-low]\n"


#: They print a part of what they ask for, or one object after the other.
OTHERWISE = (
    "mission show",
    "zones show",
    "params get",
    "logs read",
    "virtual start survey",
    "run watch",
    "plan run p1",
)
WHOLE = [case for case in CASES if isinstance(case.answer, dict) and not case.line.startswith(OTHERWISE)]


@pytest.mark.parametrize("case", WHOLE, ids=str)
def test_json_is_what_the_server_sent(server: FakeServer, case: Case) -> None:
    prepared(server, case)
    assert json.loads(run(server, *case.line.split(), "--json").stdout) == case.answer


@pytest.mark.parametrize(
    "line",
    [case.line.removesuffix(" --yes") for case in CASES if case.line.endswith(" --yes")] + ["mission clear"],
)
def test_what_destroys_is_refused_where_nobody_can_be_asked(server: FakeServer, line: str) -> None:
    server.answers |= MISSIONS | ZONES | VIRTUALS | {"GET /drones/d1/parameters": samples.PARAMETERS}
    server.answers["POST /drones/d1/parameters/file"] = samples.DIFFERENCE
    result = run(server, *line.split())
    assert result.exit_code == 1
    assert "--yes" in result.stderr
    assert not [asked for asked in server.asked if asked.method in ("DELETE", "PATCH")]
    assert server.commands() == []


def test_return_all_confirms_what_its_preview_showed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("dronectl.recovery.agreed", lambda yes, question: None)
    server = FakeServer({"POST /recoveries/preview": samples.RECOVERY_PREVIEW, "POST /recoveries": samples.RECOVERY})
    result = run(server, "return", "--all", "--no-wait")
    assert result.exit_code == 0, result.output
    assert "left out: Kestrel: It is not in the air." in result.output
    assert [one.body for one in server.asked if one.path.endswith("/recoveries")] == [
        {"manner": "return", "previewed": ["d1"]}
    ]
