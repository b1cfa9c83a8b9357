"""Some drones in the air at one server, each left at its moment, and what the server suffers."""

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
from .datagram_recorder import DatagramRecorder
from .ground_station import User, new_user
from .control_loss_flights import PATIENCE, FlightClient
from .control_loss_judge import LossRecord, Judgement, Limits, judge
from .control_loss_cases import LossCase, Plan
from .runs import known
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
# Whoever has a remote control, or another ground station, goes to one of these.
BY_HAND = {"guided": 5, "velocity": 16, "sticks": 2, "mission": 5, "run": 16, "follow": 2, "virtual": 5}
OTHER_STATION = 252
SAYS_SO = 2.0
ALL_UP = 120.0
ALL_DOWN = 150.0
# Whoever has handed over goes on for so long, where they insist: less than whom it was handed to has.
INSISTS = 3.0
# A pilot's vehicle is watched for so long after all that could call it back.
PILOTS = 10.0


class Sortie:
    def __init__(
        self,
        plan: Plan,
        folder: Path,
        faults: Path | None = None,
        on_loss: str = "return",
        longest: float = ALL_DOWN,
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
        self.flyers: list[FlightClient] = []
        self.happened: dict[int, LossRecord] = {}
        self.away: tuple[float, float] | None = None

    def fly(self) -> list[Judgement]:
        self.server.start()
        recorder = DatagramRecorder(self.server.udp_port)
        moments = self.plan.moments
        simulator = Simulator(
            self._folder / "sim.log",
            f"udp://127.0.0.1:{recorder.port}",
            *("--count", str(len(moments)), "--sysid", str(FIRST), "--seed", str(self.plan.seed)),
            *(*FLIGHT, "--parameter", f"FS_GCS_ENABLE={self.plan.failsafe}"),
        )
        self._recorder, self._simulator = recorder, simulator
        try:
            self._into_the_air()
            self._moments()
            self._until_all_is_over()
            return [
                judge(one.moment, recorder.of(one.system_id), self.happened[one.system_id], LIMITS)
                for one in self.flyers
            ]
        finally:
            for one in self.flyers:
                one.leave()
            simulator.stop()
            recorder.close()
            self.server.stop()

    def _admin(self) -> Api:
        return Api(self.server.address, self.server.local_key())

    def _into_the_air(self) -> None:
        admin = self._admin()
        for number, moment in enumerate(self.plan.moments):
            drone = wait_for(f"{moment}: all is known", partial(known, admin, FIRST + number), 120)
            self.flyers.append(self._flyer(admin, moment, FIRST + number, drone))
        with ThreadPoolExecutor(len(self.flyers)) as pool:
            list(pool.map(FlightClient.prepare, self.flyers))
            list(pool.map(FlightClient.start, self.flyers))
        wait_for("all fly", lambda: all(one.flies() for one in self.flyers), ALL_UP)

    def _flyer(self, admin: Api, moment: LossCase, system_id: int, drone: Json) -> FlightClient:
        user = new_user(self.server, admin, "operator")
        if moment.how == "grant":
            _only(admin, user, drone["id"])
        key = None if moment.event == "sign out" else user.api.new_key("moment", "operator")
        absent = ""
        if moment.event == "hand over":
            absent = f"absent-{secrets.token_hex(4)}"
            body = {"name": absent, "password": secrets.token_hex(10), "role": "operator"}
            assert admin.call("POST", "/users", body).status_code == 201
        return FlightClient(moment, system_id, drone, self.server, user, key, admin, absent)

    def _moments(self) -> None:
        """Each at its time, and the server's last."""
        began = time.monotonic()
        mine: list[tuple[float, Callable[[], None]]] = [
            (one.moment.after, partial(self._leave, one))
            for one in self.flyers
            if one.moment.event not in (self.plan.suffers, "pilot while away")
        ]
        for after, act in sorted(mine, key=lambda one: one[0]):
            _sleep_until(began + after)
            act()
        _sleep_until(began + self.plan.suffers_after)
        self._suffer()

    def _leave(self, one: FlightClient) -> None:
        moment = one.moment
        happened = LossRecord(left=time.monotonic())
        if moment.event == "vanish":
            one.leave()
        elif moment.event == "hand over":
            if not one.epoch:
                one.api.call("POST", f"/drones/{one.id}/control/take")
            answer = one.api.call("POST", f"/drones/{one.id}/control/hand-over", {"user": one.absent})
            assert answer.ok, answer.text
            # Nobody has it when the other one did not come, and whoever commands it then has it rightly.
            threading.Timer(INSISTS, one.stop_sending).start()
        elif moment.event == "revoke":
            self._revoke(one)
        elif moment.event == "sign out":
            assert one.user.api.call("DELETE", "/session").ok
        else:
            self._pilot(one)
            happened.piloted = happened.left
        if not moment.insists:
            one.stop_sending()
        if moment.event != "vanish":
            # Joining a thread takes no time that the drone is left alone in.
            happened.left = max(happened.left, time.monotonic() if moment.event != "pilot" else 0)
        self.happened[one.system_id] = happened

    def _revoke(self, one: FlightClient) -> None:
        admin = self._admin()
        if one.moment.how == "grant":
            (grant,) = [each for each in admin.get("/grants")["grants"] if each["user"] == one.user.name]
            answer = admin.call("DELETE", f"/grants/{grant['id']}")
        elif one.moment.how == "user":
            answer = admin.call("PATCH", f"/users/{one.user.name}", {"state": "disabled"})
        else:
            (key,) = admin.get(f"/users/{one.user.name}/access-keys")["accessKeys"]
            answer = admin.call("DELETE", f"/users/{one.user.name}/access-keys/{key['id']}")
        assert answer.ok, answer.text

    def _pilot(self, one: FlightClient) -> None:
        mode = BY_HAND[one.moment.kind]
        if one.moment.how == "by switch":
            self._simulator.fault(f"{one.system_id} mode {mode}")
            return
        station = mavlink.MAVLink(None, srcSystem=OTHER_STATION, srcComponent=190)
        message = mavlink.MAVLink_set_mode_message(
            one.system_id, mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, mode
        )
        self._recorder.inject(one.system_id, message.pack(station))

    def _suffer(self) -> None:
        stays = [one for one in self.flyers if one.moment.event == self.plan.suffers]
        pilots = [one for one in self.flyers if one.moment.event == "pilot while away"]
        for one in [*stays, *pilots]:
            # Not closed yet: the server does not know before.
            one.stop_sending()
        if self.plan.suffers == "standstill":
            self._stand_still(stays, pilots)
            return
        begin = time.monotonic()
        for one in stays:
            self.happened[one.system_id] = LossRecord(left=begin)
        if self.plan.suffers == "kill":
            self.server.kill()
        else:
            self._use_up_the_heap()
        self._pilots(pilots)
        time.sleep(self.plan.down)
        self.server.start()
        self.away = (begin, time.monotonic())

    def _stand_still(self, stays: list[FlightClient], pilots: list[FlightClient]) -> None:
        places: dict[int, Json] = {}
        for one in stays:
            if one.moment.kind == "guided":
                # It does not arrive: it would be said again and again, if time did not go by.
                self._recorder.withheld_from.add(one.system_id)
                places[one.system_id] = one.goes_to(35 + one.system_id)
        time.sleep(1 if places else 0)
        begin = time.monotonic()
        os.kill(self.server.pid, signal.SIGSTOP)
        self._recorder.withheld_from.clear()
        for one in stays:
            # Who has a stream open is there: these have gone when the server looks again.
            one.leave()
        for one in stays:
            forgotten = [
                (round(place["latitude"] * 1e7), round(place["longitude"] * 1e7))
                for place in [places.get(one.system_id)]
                if place
            ]
            self.happened[one.system_id] = LossRecord(left=begin, forgotten=forgotten)
        self._pilots(pilots)
        _sleep_until(begin + STANDSTILL)
        os.kill(self.server.pid, signal.SIGCONT)
        self.away = (begin, time.monotonic())
        for one in stays:
            if one.epoch:
                # Late: whoever had it was silent for all that time.
                self.happened[one.system_id].kept = _signs(one)

    def _pilots(self, pilots: list[FlightClient]) -> None:
        time.sleep(0.5)
        for one in pilots:
            at = time.monotonic()
            self._pilot(one)
            self.happened[one.system_id] = LossRecord(left=at, piloted=at)

    def _use_up_the_heap(self) -> None:
        assert self._faults is not None
        subprocess.run(["java", "-jar", self._faults, str(self.server.pid), "heap"], check=True, timeout=60)
        wait_for("the server has ended", lambda: not self.server.runs(), 120)

    def _until_all_is_over(self) -> None:
        assert self.away is not None
        for happened in self.happened.values():
            happened.away = self.away
            happened.stood_still = self.plan.suffers == "standstill"
        pilots = {one.system_id for one in self.flyers if one.moment.event.startswith("pilot")}
        others = {one.system_id for one in self.flyers} - pilots
        last = max(self.away[1], *(one.left for one in self.happened.values()))
        watch = last + LIMITS.idle + LIMITS.until_return + PILOTS
        for _ in rounds(time.monotonic() + self._longest, 1.0):
            down = self._down()
            if others <= down and (not pilots or time.monotonic() > watch):
                break
        for system_id in pilots:
            self.happened[system_id].until = time.monotonic()
        # Whoever is down has said so by then.
        time.sleep(SAYS_SO)

    def _down(self) -> set[int]:
        """By what truly is."""
        lines = self._simulator.ask("list").splitlines()
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
