"""Speeds and sticks of other programs steer through the outlet, and the drone stands when they stop."""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api
from dronemap_e2e.copter import Copter, landed
from dronemap_e2e.ground import Attach, Ground, granted
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import wait_for

ACCEPTED, DENIED = 0, 2
GUIDED, LOITER = 4, 5
SPEEDS_ONLY = 0xDC7


def speed(ground: Ground, number: int) -> float:
    """Over ground, in m/s, as told last."""
    told = ground.heard("VFR_HUD", number)
    return float(told[-1].groundspeed) if told else 0.0


@contextmanager
def said_on(say: Callable[[], None]) -> Iterator[None]:
    """Says the same ten times a second, as programs that steer do."""
    over = threading.Event()

    def run() -> None:
        while not over.wait(0.1):
            say()

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    yield
    over.set()
    thread.join(5)


def entries(api: Api, drone: str) -> list[dict[str, Any]]:
    """The log of who steered, and who was not let to, the newest first, once each has ended."""
    told = api.get(f"/drones/{drone}/commands")["commands"]
    return [c for c in told if c["summary"].startswith("steer by ") and c["outcome"]]


def turns(api: Api, drone: str) -> list[dict[str, Any]]:
    return [entry for entry in entries(api, drone) if entry["outcome"]["result"] != "refused"]


def take_off(api: Api, ground: Ground, number: int, drone: str) -> None:
    assert ground.command(number, mavlink.MAV_CMD_DO_SET_MODE, 1, GUIDED) == ACCEPTED
    assert ground.command(number, mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1) == ACCEPTED
    assert ground.command(number, mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 15) == ACCEPTED
    wait_for("it is up", lambda: (api.drone(drone)["position"]["altitudeAboveHome"] or 0) > 14, 60)


def northward(ground: Ground, number: int, component: int = 1) -> None:
    target = (0, number, component, mavlink.MAV_FRAME_LOCAL_NED, SPEEDS_ONLY)
    ground.say("set_position_target_local_ned", *target, *(0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0))


def test_speeds_and_sticks_steer_a_drone_and_it_stands_when_they_stop(
    server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    drone = copters[0].id
    pilot = granted(server, api, "operator", [drone])
    ground = attach(pilot)
    (number,) = ground.wait_vehicles(1)
    take_off(api, ground, number, drone)

    with said_on(partial(northward, ground, number)):
        wait_for("it is steered by speeds", lambda: speed(ground, number) > 3)
    wait_for("it stands without another word", lambda: speed(ground, number) < 0.5, 20)
    (turn,) = turns(api, drone)
    assert (turn["by"], turn["face"], turn["summary"]) == (pilot.name, "outlet", "steer by speeds")
    assert turn["outcome"]["result"] == "timedOut" and "stand still" in turn["outcome"]["reason"]

    def forward() -> None:
        ground.say("manual_control", number, 400, 0, 500, 0, 0)

    forward()
    wait_for("sticks do nothing in GUIDED", lambda: "mode to LOITER" in "".join(ground.texts().split("\n")))
    assert ground.command(number, mavlink.MAV_CMD_DO_SET_MODE, 1, LOITER) == ACCEPTED
    supervisor = granted(server, api, "supervisor", [drone])
    with said_on(forward):
        wait_for("it is steered by sticks", lambda: speed(ground, number) > 3)
        taken = supervisor.api.call("POST", f"/drones/{drone}/control/take-over", {"reason": "a helicopter"})
        assert taken.ok, taken.text
        wait_for("it stands whatever the sticks say", lambda: speed(ground, number) < 0.5)
    assert turns(api, drone)[0]["outcome"]["result"] == "superseded"
    refused = {e["outcome"]["reason"] for e in entries(api, drone)} - {
        t["outcome"]["reason"] for t in turns(api, drone)
    }
    assert any("change its mode to LOITER" in reason for reason in refused), (
        "who may not steer so is written down"
    )
    assert supervisor.api.call("POST", f"/drones/{drone}/commands", {"type": "land"}).ok
    wait_for("it is down", partial(landed, api, drone), 60)


def test_who_is_disabled_while_steering_steers_no_more_and_has_no_control(
    server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    drone = copters[1].id
    pilot = granted(server, api, "operator", [drone])
    ground = attach(pilot)
    (number,) = ground.wait_vehicles(1)
    take_off(api, ground, number, drone)

    with said_on(partial(northward, ground, number)):
        wait_for("it is steered", lambda: speed(ground, number) > 3)
        assert api.call("PATCH", f"/users/{pilot.name}", {"state": "disabled"}).ok
        wait_for("it stands", lambda: (api.drone(drone)["motion"]["groundSpeed"] or 0) < 0.5)
    (turn,) = turns(api, drone)
    assert turn["outcome"]["result"] == "superseded"
    assert api.drone(drone)["control"]["holder"] is None
    assert api.call("POST", f"/drones/{drone}/commands", {"type": "land"}).ok
    wait_for("it is down", partial(landed, api, drone), 60)


PLACE_ONLY, GIMBAL = 0xDF8, 154


def test_a_place_said_over_and_over_leads_until_somebody_takes_over(
    server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    drone = copters[1].id
    pilot = granted(server, api, "operator", [drone])
    supervisor = granted(server, api, "supervisor", [drone])
    ground = attach(pilot)
    (number,) = ground.wait_vehicles(1)
    # Whoever landed it before has no more use for it.
    api.call("DELETE", f"/drones/{drone}/control")
    take_off(api, ground, number, drone)
    northward(ground, number, GIMBAL)
    wait_for("a gimbal is not steered", lambda: f"component {GIMBAL}" in "".join(ground.texts().split("\n")))
    ground.say("command_long", number, GIMBAL, mavlink.MAV_CMD_NAV_LAND, 0, *([0.0] * 7))
    wait_for("nor landed", lambda: [m.result for m in ground.heard("COMMAND_ACK", number)][-1] == DENIED)
    assert turns(api, drone)[0]["outcome"]["result"] == "superseded", "the one of the test before"
    home = api.drone(drone)["home"]
    north = round((home["latitude"] + 0.02) * 1e7), round(home["longitude"] * 1e7)

    def towards() -> None:
        target = (0, number, 1, mavlink.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT, PLACE_ONLY)
        ground.say("set_position_target_global_int", *target, *north, 15, 0, 0, 0, 0, 0, 0, 0, 0)

    def leads() -> bool:
        told = api.get(f"/drones/{drone}/commands")["commands"]
        return any(c["summary"] == "lead it by a place" and not c["outcome"] for c in told)

    with said_on(towards):
        wait_for("it is led", leads)
        wait_for("it flies there", lambda: speed(ground, number) > 3)
        taken = supervisor.api.call("POST", f"/drones/{drone}/control/take-over", {"reason": "a helicopter"})
        assert taken.ok, taken.text
        wait_for("it stands whatever is said", lambda: speed(ground, number) < 0.5)
    assert supervisor.api.call("POST", f"/drones/{drone}/commands", {"type": "land"}).ok
    wait_for("it is down", partial(landed, api, drone), 60)
