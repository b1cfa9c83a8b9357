"""The server killed with -9 while drones follow: what comes of each follow is in docs/following.md."""

import time
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import pytest

from dronemap_e2e.api import Api
from dronemap_e2e.flight import COPTER_RTL
from dronemap_e2e.followed_phones import (
    COPTER_LAND,
    FollowedPhone,
    FollowGroup,
    ReportedState,
    stages_by_soap,
    stages_by_stream,
)
from dronemap_e2e.message_recorder import MessageRecorder
from dronemap_e2e.server import ROOT, Server
from dronemap_e2e.simulator import Simulator
from dronemap_e2e.waiting import throughout, wait_for

LOITER = 5
# Two fields far from each other. Over the first one drones stand for ten minutes without the cloud.
PATIENT, HOME_ON_LOSS = 1, 101
ELSEWHERE = "47.4100,8.5456,488"
# Over its home each waits for so long before it comes down: it is in the air yet when the server is back.
LOITERS = ("--parameter", "RTL_LOIT_TIME=40000")
HEIGHT, LOW, HIGH = 20, 6, 45
LONG = 600
# Longer than a start of the server with nobody called in, and than three seconds of looking.
SHORT = 20
SHORTEST = 10
STRAYS_METRES = 3.0
# From one who has it to the next, and until both are told of it.
ALONE_SECONDS = 2.0
WALKS_METRES = 15.0
NEAR_METRES = 6.0


@dataclass(frozen=True)
class Case:
    """A follow's stage when the server is killed, what happens meanwhile, and the expected stages."""

    name: str
    at: str
    stages: tuple[str, ...]
    # One of the sentences that it says afterwards.
    message: str = ""
    home_on_loss: bool = False
    patience: int = LONG
    # Its phone says where it is also when the server is back.
    sends_positions: bool = True
    # Its drone is not heard from before it was started until the server is back.
    silent_before_start: bool = False
    # Into that mode, by the pilot's own switch, while there is no server.
    pilot_mode: int | None = None


FOLLOWS_AGAIN = "it follows again"
COMES_HOME = "comes home since it missed the cloud"
UP = "is in the air and follows"
CASES = (
    Case("kept", "allocated", ("allocated",)),
    Case("climbs", "starting", ("starting", "tracking"), UP),
    Case("follows", "tracking", ("tracking",)),
    Case(
        "fell silent",
        "tracking",
        ("tracking", "returning", "over"),
        "said nothing for 20 s",
        patience=SHORT,
        sends_positions=False,
    ),
    Case("waits", "paused", ("paused",)),
    Case("a pilot's", "suspended", ("suspended",)),
    # A supervisor who does not come back is no plan.
    Case("a supervisor's", "suspended", ("suspended", "over"), "is down; it is over"),
    Case("comes home", "returning", ("returning", "over"), "is down; it is over"),
    Case("landed", "tracking", ("tracking", "over"), "has landed; it is over", pilot_mode=COPTER_LAND),
    Case("taken", "tracking", ("tracking", "suspended"), "a pilot flies it in LOITER", pilot_mode=LOITER),
    Case("on the ground", "starting", ("starting", "tracking"), UP, silent_before_start=True),
    Case(
        "too late",
        "starting",
        ("returning", "over"),
        "came back too late",
        patience=SHORTEST,
        silent_before_start=True,
    ),
    Case("missed, climbs", "starting", ("starting", "tracking"), UP, home_on_loss=True),
    Case(
        "missed, follows", "tracking", ("tracking", "starting", "tracking"), FOLLOWS_AGAIN, home_on_loss=True
    ),
    Case(
        "missed, fell silent",
        "tracking",
        ("tracking", "returning", "over"),
        COMES_HOME,
        home_on_loss=True,
        patience=SHORT,
        sends_positions=False,
    ),
    Case("missed, waits", "paused", ("paused", "returning", "over"), COMES_HOME, home_on_loss=True),
    Case("missed, comes home", "returning", ("returning", "over"), "is down; it is over", home_on_loss=True),
)


def documented_outcomes() -> dict[str, str]:
    """The documented outcomes of a restart, by stage."""
    rows = [
        [cell.strip() for cell in line.strip("|").split("|")]
        for line in (ROOT / "docs" / "following.md").read_text().splitlines()
        if line.startswith(("| operation or event", "| restarted"))
    ]
    head, row = rows
    return dict(zip(head[1:], row[1:], strict=True))


@dataclass
class CrashTrial:
    """All cases at once: a server that dies, two fields of copters, and a recorder of their messages."""

    server: Server
    recorder: MessageRecorder
    fields: dict[bool, Simulator]
    phone_key: str
    supervisor_key: str
    follows: dict[Case, FollowedPhone] = field(default_factory=dict)
    dead_since: float = 0.0
    # Since when nobody cares for it.
    alone: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.reported = ReportedState(self.recorder)
        self.phone = Api(self.server.address, self.phone_key)

    @property
    def group(self) -> FollowGroup:
        return FollowGroup(self.follows.values(), self.reported)

    def follows_where(self, **wanted: object) -> list[FollowedPhone]:
        return [
            one
            for case, one in self.follows.items()
            if all(getattr(case, name) == value for name, value in wanted.items())
        ]

    def named(self, name: str) -> FollowedPhone:
        (found,) = self.follows_where(name=name)
        return found

    def stages(self) -> dict[str, str]:
        seen = self.group.follows_by_id(self.phone)
        return {case.name: seen[one.follow]["state"] for case, one in self.follows.items()}

    def request_follows(self) -> None:
        ids = {
            home_on_loss: iter(range(HOME_ON_LOSS if home_on_loss else PATIENT, 255))
            for home_on_loss in (False, True)
        }
        for case in CASES:
            system_id = next(ids[case.home_on_loss])
            drone = wait_for("a copter is ready", partial(self.phone.ready, system_id), 90)
            height = HIGH if case.at == "starting" else LOW if case.pilot_mode == COPTER_LAND else HEIGHT
            self.follows[case] = FollowedPhone(system_id, drone, height, case.patience)
            self.follows[case].request_follow(self.phone)

    def bring_to_stages(self) -> None:
        """Each to where it shall be; last those who climb and who come home, as they do not stay there."""
        for one in self.follows_where(silent_before_start=True):
            self.recorder.cut.add(one.system_id)
            one.request(self.phone, "start")
        fly = [one for case, one in self.follows.items() if case.at not in ("allocated", "starting")]
        for one in fly:
            one.request(self.phone, "start")
        self.wait_until(
            "all are there", lambda: all(self.reported.metres_to(one, one.place) < 3 for one in fly), 90
        )
        for one in self.follows_where(at="paused"):
            one.request(self.phone, "pause")
        self.switch(self.named("a pilot's"), False, LOITER)
        climb = self.follows_where(at="starting", silent_before_start=False)
        for one in climb:
            one.request(self.phone, "start")
        self.take_off_all(climb)
        back = self.follows_where(at="returning")
        for one in back:
            one.request(self.phone, "stop")
        self.wait_until(
            "they come home", lambda: all(self.reported.mode(one) == COPTER_RTL for one in back), 10
        )
        # Who says nothing for six seconds loses it: this one has it when the server dies.
        taken = self.named("a supervisor's").drone["id"]
        answer = Api(self.server.address, self.supervisor_key).call(
            "POST", f"/drones/{taken}/control/take-over", {"reason": "a look"}
        )
        assert answer.ok, answer.text
        self.wait_until("all are there", lambda: self.stages() == {c.name: c.at for c in CASES}, 5)

    def switch(self, one: FollowedPhone, home_on_loss: bool, mode: int) -> None:
        self.fields[home_on_loss].fault(f"{one.system_id} mode {mode}")
        one.piloted = mode == LOITER

    def take_off_all(self, climb: list[FollowedPhone]) -> None:
        """Takes off; cuts each link once its take-off was commanded, as that stage is over soon."""

        def commanded() -> bool:
            self.recorder.cut |= {one.system_id for one in climb if self.reported.take_off_commanded(one)}
            return all(one.system_id in self.recorder.cut for one in climb)

        wait_for("they are told to take off", commanded, 30, every=0.05)
        self.wait_until("they climb", lambda: all(self.reported.height(one) > 3 for one in climb), 30)

    def wait_until(self, what: str, condition: object, seconds: float) -> None:
        assert callable(condition)
        try:
            self.group.wait_until(self.phone, what, condition, seconds)
        except AssertionError as wrong:
            raise AssertionError(f"{wrong}: {self.stages()}") from wrong

    def kill_server(self) -> None:
        """Kills the server, with all links cut until they are reconnected."""
        self.recorder.cut |= {one.system_id for one in self.group.phones}
        self.server.kill()
        self.dead_since = time.monotonic()
        for case, one in self.follows.items():
            if case.pilot_mode is not None:
                self.switch(one, case.home_on_loss, case.pilot_mode)
        missing = self.follows_where(home_on_loss=True)
        wait_for("they miss it", lambda: all(self.reported.mode(one) == COPTER_RTL for one in missing), 30)
        landed = self.follows_where(pilot_mode=COPTER_LAND)
        wait_for("it is down", lambda: not any(self.reported.armed(one) for one in landed), 60)

    def restart_server(self) -> None:
        self.server.start()
        self.phone = Api(self.server.address, self.phone_key)
        for case, one in self.follows.items():
            one.sends_positions = case.sends_positions
            one.stages.clear()

    def reconnect_vehicles(self) -> None:
        for one in self.group.phones:
            self.recorder.cut.discard(one.system_id)

    def check_settled(self) -> None:
        """Each to where it shall be; all along none is left alone."""
        drones = {one.drone["id"] for one in self.group.phones}

        def live() -> bool:
            return all(
                drone["link"]["state"] == "live" for drone in self.phone.drones() if drone["id"] in drones
            )

        def settled() -> bool:
            now, alone = time.monotonic(), self.group.unattended(self.phone)
            self.alone = {one: self.alone.get(one, now) for one in alone}
            assert all(now - since < ALONE_SECONDS for since in self.alone.values()), self.alone
            return self.stages() == {case.name: case.stages[-1] for case in CASES}

        self.wait_until("all have called in", live, 30)
        self.wait_until("each is where it shall be", settled, 300)
        for case, one in self.follows.items():
            print(f"{case.name}: {' '.join(one.stages)}")
            # What lasts for less than a look may be missed.
            expected = iter(case.stages)
            assert all(stage in expected for stage in one.stages), f"{case.name}: {one.stages}"
            messages = [each["words"] for each in self.phone.get(f"/follows/{one.follow}")["told"]]
            assert any(case.message in words for words in messages), f"{case.name}: {messages}"

    def check_vehicles(self) -> None:
        """Checks by the vehicles' own messages that they are where the follows are."""
        for case, one in self.follows.items():
            if case.stages[-1] in ("allocated", "over"):
                assert not self.reported.armed(one), case.name
        for name in ("waits", "a pilot's"):
            strayed = self.reported.distance_moved(self.named(name), self.dead_since)
            assert strayed < STRAYS_METRES, f"{name}: {strayed:.1f} m"
        led = self.follows_where(stages=("tracking",)) + self.follows_where(stages=("starting", "tracking"))
        led += self.follows_where(stages=("tracking", "starting", "tracking"))
        for one in led:
            one.east += WALKS_METRES
        self.wait_until(
            "they follow",
            lambda: all(self.reported.metres_to(one, one.place) < NEAR_METRES for one in led),
            60,
        )

    def end_all(self) -> None:
        """Ends all follows; drones return, except those that a pilot flies."""
        self.named("kept").request(self.phone, "cancel")
        for case, one in self.follows.items():
            if case.stages[-1] in ("tracking", "paused"):
                one.request(self.phone, "stop")
        piloted = [one for one in self.group.phones if one.piloted]
        for one in piloted:
            one.request(self.phone, "stop")
        self.wait_until("all is over", lambda: set(self.stages().values()) == {"over"}, 180)
        for one in self.group.phones:
            assert self.reported.armed(one) == one.piloted, one.system_id
        assert all(self.reported.mode(one) == LOITER for one in piloted)

    def stages_by_interface(self) -> list[dict[str, str]]:
        ids = {one.follow: case.name for case, one in self.follows.items()}
        return [
            self.stages(),
            *(
                {ids[follow]: state for follow, state in face(self.server, self.phone_key, ids).items()}
                for face in (stages_by_soap, stages_by_stream)
            ),
        ]


@pytest.fixture
def trial(own_server: Server, tmp_path: Path) -> Iterator[CrashTrial]:
    api = Api(own_server.address, own_server.local_key())
    keys = api.new_key("phone", "operator"), api.new_key("desk", "supervisor")
    with closing(MessageRecorder(own_server.udp_port, ReportedState.KINDS)) as recorder:
        address = f"udp://127.0.0.1:{recorder.port}"
        fields = {}
        for home_on_loss, first in ((False, PATIENT), (True, HOME_ON_LOSS)):
            count = str(sum(case.home_on_loss == home_on_loss for case in CASES))
            options = ("--count", count, "--sysid", str(first), *LOITERS)
            more = ("--home", ELSEWHERE) if home_on_loss else ("--parameter", "FS_GCS_TIMEOUT=600")
            fields[home_on_loss] = Simulator(tmp_path / f"sim-{first}.log", address, *options, *more)
        yield CrashTrial(own_server, recorder, fields, *keys)
        for simulator in fields.values():
            simulator.stop()


@pytest.mark.soak
def test_follows_after_server_crash_match_documentation(trial: CrashTrial) -> None:
    trial.request_follows()
    trial.bring_to_stages()
    trial.kill_server()
    trial.restart_server()

    table = documented_outcomes()
    row = {case.name: case.stages[0] if case.name == "too late" else table[case.at] for case in CASES}
    assert trial.stages_by_interface() == [row] * 3
    throughout("nothing is decided on who has not called in", lambda: trial.stages() == row, 3)

    trial.reconnect_vehicles()
    trial.check_settled()
    trial.check_vehicles()
    trial.end_all()
