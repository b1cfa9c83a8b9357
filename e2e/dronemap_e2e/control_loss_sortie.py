"""One sortie: drones at one server whose controllers are lost one by one, and a fault of the server."""

import os
import secrets
import signal
import subprocess
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import requests
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from .api import Api, Json
from .control_loss_cases import LossCase, SortiePlan
from .control_loss_flights import PATIENCE, FlightClient
from .control_loss_judge import Judgement, Limits, LossRecord, judge
from .datagram_recorder import DatagramRecorder
from .ground_station import User, new_user
from .runs import ready_drone
from .server import ROOT, Server
from .simulator import Simulator
from .waiting import rounds, wait_for

LIMITS = Limits(lost=5, idle=5, until_return=4, patience=PATIENCE)
STANDSTILL = 20.0
FIRST = 11
# As QUICK_FLIGHT, but slow on its way: nobody is at its end before its moment.
FLIGHT = (
    *("--speedup", "5", "--parameter", "RTL_ALT=800", "--parameter", "RTL_LOIT_TIME=0"),
    *("--parameter", "LAND_SPEED=150", "--parameter", "WPNAV_SPEED=300", "--parameter", "LOIT_SPEED=300"),
)
# Modes that a pilot chooses, by remote control or another ground station.
PILOT_MODES = {"guided": 5, "velocity": 16, "sticks": 2, "mission": 5, "run": 16, "follow": 2, "virtual": 5}
OTHER_STATION = 252
SETTLE = 2.0
TAKE_OFF_LIMIT = 120.0
LANDING_LIMIT = 150.0
# A client that has handed over goes on for so long: less than the other user has to come.
KEEPS_SENDING = 3.0
# A pilot's vehicle is watched for so long after all that could call it back.
PILOT_WATCH = 10.0


class Sortie:
    """Flies all cases of a plan at one server and judges them."""

    def __init__(
        self,
        plan: SortiePlan,
        folder: Path,
        faults: Path | None = None,
        on_loss: str = "return",
        longest: float = LANDING_LIMIT,
    ) -> None:
        """`faults`: the program that uses up a heap, needed where the plan says so; `on_loss`: as the server
        is set."""
        self._longest = longest
        self.plan = plan
        self._folder = folder
        self._faults = faults
        self.server = Server(
            folder / "data",
            DRONEMAP_CONTROL_LOST_SECONDS=f"{LIMITS.lost:g}",
            DRONEMAP_CONTROL_IDLE_SECONDS=f"{LIMITS.idle:g}",
            DRONEMAP_CONTROL_RETURN_SECONDS=f"{LIMITS.until_return:g}",
            DRONEMAP_RATE_SIGN_INS="0",
            # As `./dronemap up` starts it.
            JAVA_TOOL_OPTIONS="-XX:+ExitOnOutOfMemoryError",
            DRONEMAP_CONTROL_LOST=on_loss,
        )
        self.clients: list[FlightClient] = []
        self.happened: dict[int, LossRecord] = {}
        self.server_away: tuple[float, float] | None = None

    def fly(self) -> list[Judgement]:
        self.server.start()
        recorder = DatagramRecorder(self.server.udp_port)
        cases = self.plan.cases
        simulator = Simulator(
            self._folder / "sim.log",
            f"udp://127.0.0.1:{recorder.port}",
            *("--count", str(len(cases)), "--sysid", str(FIRST), "--seed", str(self.plan.seed)),
            *(*FLIGHT, "--parameter", f"FS_GCS_ENABLE={self.plan.failsafe}"),
        )
        self._recorder, self._simulator = recorder, simulator
        try:
            self._take_off_all()
            self._lose_control()
            self._wait_until_landed()
            return [
                judge(one.case, recorder.of(one.system_id), self.happened[one.system_id], LIMITS)
                for one in self.clients
            ]
        finally:
            for one in self.clients:
                one.disconnect()
            simulator.stop()
            recorder.close()
            self.server.stop()

    def _admin_api(self) -> Api:
        return Api(self.server.address, self.server.local_key())

    def _take_off_all(self) -> None:
        admin = self._admin_api()
        for number, case in enumerate(self.plan.cases):
            drone = wait_for(f"{case}: all is known", partial(ready_drone, admin, FIRST + number), 120)
            self.clients.append(self._client(admin, case, FIRST + number, drone))
        with ThreadPoolExecutor(len(self.clients)) as pool:
            list(pool.map(FlightClient.prepare, self.clients))
            list(pool.map(FlightClient.start, self.clients))
        wait_for("all fly", lambda: all(one.is_flying() for one in self.clients), TAKE_OFF_LIMIT)

    def _client(self, admin: Api, case: LossCase, system_id: int, drone: Json) -> FlightClient:
        user = new_user(self.server, admin, "operator")
        if case.how == "grant":
            _only(admin, user, drone["id"])
        key = None if case.event == "sign out" else user.api.new_key("moment", "operator")
        absent_user = ""
        if case.event == "hand over":
            absent_user = f"absent-{secrets.token_hex(4)}"
            body = {"name": absent_user, "password": secrets.token_hex(10), "role": "operator"}
            assert admin.call("POST", "/users", body).status_code == 201
        return FlightClient(case, system_id, drone, self.server, user, key, admin, absent_user)

    def _lose_control(self) -> None:
        """Each at its time, and the server's last."""
        began = time.monotonic()
        mine: list[tuple[float, Callable[[], None]]] = [
            (one.case.after, partial(self._lose, one))
            for one in self.clients
            if one.case.event not in (self.plan.server_event, "pilot while away")
        ]
        for after, act in sorted(mine, key=lambda one: one[0]):
            _sleep_until(began + after)
            act()
        _sleep_until(began + self.plan.server_event_after)
        self._apply_server_event()

    def _lose(self, one: FlightClient) -> None:
        case = one.case
        happened = LossRecord(lost_at=time.monotonic())
        if case.event == "vanish":
            one.disconnect()
        elif case.event == "hand over":
            if not one.epoch:
                one.api.call("POST", f"/drones/{one.id}/control/take")
            answer = one.api.call("POST", f"/drones/{one.id}/control/hand-over", {"user": one.absent_user})
            assert answer.ok, answer.text
            # Nobody has it when the other user did not come; a command then takes control by right.
            threading.Timer(KEEPS_SENDING, one.stop_sending).start()
        elif case.event == "revoke":
            self._revoke(one)
        elif case.event == "sign out":
            assert one.user.api.call("DELETE", "/session").ok
        else:
            self._pilot(one)
            happened.piloted_at = happened.lost_at
        if not case.keeps_sending:
            one.stop_sending()
        if case.event != "vanish":
            # Joining a thread takes no time that the drone is left alone in.
            happened.lost_at = max(happened.lost_at, time.monotonic() if case.event != "pilot" else 0)
        self.happened[one.system_id] = happened

    def _revoke(self, one: FlightClient) -> None:
        admin = self._admin_api()
        if one.case.how == "grant":
            (grant,) = [each for each in admin.get("/grants")["grants"] if each["user"] == one.user.name]
            answer = admin.call("DELETE", f"/grants/{grant['id']}")
        elif one.case.how == "user":
            answer = admin.call("PATCH", f"/users/{one.user.name}", {"state": "disabled"})
        else:
            (key,) = admin.get(f"/users/{one.user.name}/access-keys")["accessKeys"]
            answer = admin.call("DELETE", f"/users/{one.user.name}/access-keys/{key['id']}")
        assert answer.ok, answer.text

    def _pilot(self, one: FlightClient) -> None:
        mode = PILOT_MODES[one.case.kind]
        if one.case.how == "by switch":
            self._simulator.fault(f"{one.system_id} mode {mode}")
            return
        station = mavlink.MAVLink(None, srcSystem=OTHER_STATION, srcComponent=190)
        message = mavlink.MAVLink_set_mode_message(
            one.system_id, mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, mode
        )
        self._recorder.inject(one.system_id, message.pack(station))

    def _apply_server_event(self) -> None:
        stays = [one for one in self.clients if one.case.event == self.plan.server_event]
        pilots = [one for one in self.clients if one.case.event == "pilot while away"]
        for one in [*stays, *pilots]:
            # Not closed yet: the server does not know before.
            one.stop_sending()
        if self.plan.server_event == "standstill":
            self._stand_still(stays, pilots)
            return
        begin = time.monotonic()
        for one in stays:
            self.happened[one.system_id] = LossRecord(lost_at=begin)
        if self.plan.server_event == "kill":
            self.server.kill()
        else:
            self._use_up_the_heap()
        self._pilots(pilots)
        time.sleep(self.plan.down)
        self.server.start()
        self.server_away = (begin, time.monotonic())

    def _stand_still(self, stays: list[FlightClient], pilots: list[FlightClient]) -> None:
        places: dict[int, Json] = {}
        for one in stays:
            if one.case.kind == "guided":
                # It does not arrive: it would be said again and again, if time did not go by.
                self._recorder.withheld_from.add(one.system_id)
                places[one.system_id] = one.go_to(35 + one.system_id)
        time.sleep(1 if places else 0)
        begin = time.monotonic()
        os.kill(self.server.pid, signal.SIGSTOP)
        self._recorder.withheld_from.clear()
        for one in stays:
            # Who has a stream open is there: these have gone when the server looks again.
            one.disconnect()
        for one in stays:
            expired_targets = [
                (round(target["latitude"] * 1e7), round(target["longitude"] * 1e7))
                for target in [places.get(one.system_id)]
                if target
            ]
            self.happened[one.system_id] = LossRecord(lost_at=begin, expired_targets=expired_targets)
        self._pilots(pilots)
        _sleep_until(begin + STANDSTILL)
        os.kill(self.server.pid, signal.SIGCONT)
        self.server_away = (begin, time.monotonic())
        for one in stays:
            if one.epoch:
                # Late: its controller was silent for all that time.
                self.happened[one.system_id].kept_over_standstill = _signs(one)

    def _pilots(self, pilots: list[FlightClient]) -> None:
        time.sleep(0.5)
        for one in pilots:
            at = time.monotonic()
            self._pilot(one)
            self.happened[one.system_id] = LossRecord(lost_at=at, piloted_at=at)

    def _use_up_the_heap(self) -> None:
        assert self._faults is not None
        subprocess.run(["java", "-jar", self._faults, str(self.server.pid), "heap"], check=True, timeout=60)
        wait_for("the server has ended", lambda: not self.server.runs(), 120)

    def _wait_until_landed(self) -> None:
        assert self.server_away is not None
        for happened in self.happened.values():
            happened.server_away = self.server_away
            happened.stood_still = self.plan.server_event == "standstill"
        pilots = {one.system_id for one in self.clients if one.case.event.startswith("pilot")}
        others = {one.system_id for one in self.clients} - pilots
        last = max(self.server_away[1], *(one.lost_at for one in self.happened.values()))
        watch = last + LIMITS.idle + LIMITS.until_return + PILOT_WATCH
        for _ in rounds(time.monotonic() + self._longest, 1.0):
            down = self._landed()
            if others <= down and (not pilots or time.monotonic() > watch):
                break
        for system_id in pilots:
            self.happened[system_id].observed_until = time.monotonic()
        # Vehicles that are down have reported it by then.
        time.sleep(SETTLE)

    def _landed(self) -> set[int]:
        """System ids of vehicles that are down, by the simulator."""
        lines = self._simulator.send_command("list").splitlines()
        return {int(line.split()[0]) for line in lines if " disarmed landed " in line}


def _signs(one: FlightClient) -> bool:
    path, body = f"/drones/{one.id}/control/heartbeat", {"epoch": one.epoch}
    try:
        return one.api.call("POST", path, body).ok
    except requests.ConnectionError:
        # A server that stood still ends connections that nobody used meanwhile; any client opens a new one.
        return one.api.call("POST", path, body).ok


def _only(admin: Api, user: User, drone: str) -> None:
    answer = admin.call("PUT", f"/users/{user.name}/only-granted", {"onlyGranted": True})
    assert answer.status_code == 204, answer.text
    body = {"user": user.name, "drones": [drone], "operations": ["view", "plan", "command"]}
    assert admin.call("POST", "/grants", body).status_code == 201


def _sleep_until(moment: float) -> None:
    time.sleep(max(0.0, moment - time.monotonic()))


def compile_fault_injector(folder: Path) -> Path:
    """The program of faults, made with the JDK and the libraries of a server."""
    libraries = ROOT / "dronemap-ws" / "target" / "unpacked" / "lib"
    asm = next(libraries.glob("spring-core-*.jar"))
    source = ROOT / "scripts" / "tests" / "faults" / "Faults.java"
    subprocess.run(["javac", "-nowarn", "-cp", asm, "-d", folder, source], check=True)
    manifest = folder / "manifest"
    manifest.write_text(f"Main-Class: Faults\nAgent-Class: Faults\nClass-Path: {asm.as_uri()}\n")
    jar = folder / "faults.jar"
    classes = [entry.name for entry in folder.glob("*.class")]
    subprocess.run(["jar", "cfm", jar, manifest, *classes], cwd=folder, check=True)
    return jar
