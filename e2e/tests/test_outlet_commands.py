"""Ground stations of other makers fly, read and write through the outlet; with pymavlink's own signing."""

import time
from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.api import Api
from dronemap_e2e.copter import PARAMETERS, Copter, ids, landed
from dronemap_e2e.ground import Attach, Ground, granted
from dronemap_e2e.server import Server
from dronemap_e2e.waiting import wait_for

ACCEPTED, REJECTED, DENIED, UNSUPPORTED = 0, 1, 2, 3
GUIDED = 4
GAPS_AT_ONCE = 50


def test_two_vehicles_of_one_system_id_are_flown_from_one_client(
    server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    pilot = granted(server, api, "operator", ids(copters))
    ground = attach(pilot)
    numbers = sorted(ground.wait_vehicles(2))
    for number in numbers:
        assert ground.command(number, mavlink.MAV_CMD_DO_SET_MODE, 1, GUIDED) == ACCEPTED
        assert ground.command(number, mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1) == ACCEPTED
        assert ground.command(number, mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 12) == ACCEPTED
    for number in numbers:

        def high(number: int = number) -> bool:
            return any(m.relative_alt > 11_000 for m in ground.heard("GLOBAL_POSITION_INT", number))

        wait_for("it is up there", high, 60)
    for number in numbers:
        assert ground.command(number, mavlink.MAV_CMD_NAV_LAND) == ACCEPTED
    for copter in copters:
        wait_for("it is down", partial(landed, api, copter.id), 60)
        commands = api.get(f"/drones/{copter.id}/commands")["commands"]
        assert {c["face"] for c in commands} == {"outlet"}
        assert pilot.api.call("DELETE", f"/drones/{copter.id}/control").ok


def test_a_refusal_says_why(server: Server, api: Api, copters: list[Copter], attach: Attach) -> None:
    ground = attach(granted(server, api, "viewer", ids(copters[:1])))
    (number,) = ground.wait_vehicles(1)
    told = len(copters[0].told())
    assert ground.command(number, mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1) == DENIED
    wait_for("it says why", lambda: "Your role may look, not command" in "".join(ground.texts().split("\n")))
    assert ground.command(number, mavlink.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 1) == UNSUPPORTED
    assert ground.command(number, mavlink.MAV_CMD_REQUEST_MESSAGE, 148) == ACCEPTED
    wait_for("the version comes from the cache", lambda: ground.heard("AUTOPILOT_VERSION", number))
    assert len(copters[0].told()) == told


def test_who_has_no_control_is_refused_and_told_who_has(
    server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    holder, other = (granted(server, api, "operator", ids(copters[1:])) for _ in range(2))
    assert holder.api.call("POST", f"/drones/{copters[1].id}/control/take").ok
    ground = attach(other)
    (number,) = ground.wait_vehicles(1)
    assert ground.command(number, mavlink.MAV_CMD_DO_SET_MODE, 1, GUIDED) == DENIED
    wait_for("it says who has it", lambda: holder.name in "".join(ground.texts().split("\n")))
    assert holder.api.call("DELETE", f"/drones/{copters[1].id}/control").ok
    assert ground.command(number, mavlink.MAV_CMD_DO_SET_MODE, 1, GUIDED) == ACCEPTED
    assert other.api.call("DELETE", f"/drones/{copters[1].id}/control").ok


OPERATOR_CONTROL, FAILED = 32_100, 4


def in_control(ground: Ground, number: int) -> int | None:
    """Which system has control of the vehicle, as it was told last."""
    told = ground.heard("CONTROL_STATUS", number)
    return int(told[-1].gcs_main) if told else None


def test_control_is_asked_for_and_handed_over_between_ground_stations_and_lost_with_the_holders(
    server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    drone = copters[1].id
    users = [granted(server, api, "operator", ids(copters[1:])) for _ in range(2)]
    ann, bob = attach(users[0], system_id=251), attach(users[1], system_id=252)
    (number,), (his,) = ann.wait_vehicles(1), bob.wait_vehicles(1)
    wait_for("it is free", lambda: in_control(ann, number) == 0)
    assert ann.command(number, OPERATOR_CONTROL, 1) == ACCEPTED
    wait_for("both are told", lambda: (in_control(ann, number), in_control(bob, his)) == (251, 255))

    assert bob.command(his, OPERATOR_CONTROL, 1) == FAILED
    asked = wait_for("the holder is asked", lambda: ann.heard("COMMAND_LONG", number))
    assert (asked[0].command, asked[0].target_system) == (OPERATOR_CONTROL, 251)
    wait_for(
        "and told by whom", lambda: f"{users[1].name} asks for control" in "".join(ann.texts().split("\n"))
    )
    assert ann.command(number, OPERATOR_CONTROL, 1, 1) == ACCEPTED
    wait_for("both are told", lambda: (in_control(ann, number), in_control(bob, his)) == (255, 252))

    # Taken on purpose it is kept by heartbeats alone.
    assert bob.command(his, OPERATOR_CONTROL, 1) == ACCEPTED
    bob.silent = True
    wait_for("it is lost", lambda: in_control(ann, number) == 0, 20)
    records = api.get(f"/audit?drone={drone}&limit=100")["records"]
    done = [(r["by"], r["operation"]) for r in records if r["face"] == "outlet"]
    assert (users[0].name, "requestControl") in done
    assert (users[0].name, "handControlOver") in done


def items(ground: Ground, number: int) -> list[Any]:
    """The mission as a client reads it."""
    before = len(ground.heard("MISSION_COUNT", number))
    ground.say("mission_request_list", number, 1)
    count = wait_for("it is counted", lambda: ground.heard("MISSION_COUNT", number)[before:])[0].count
    read = []
    for seq in range(count):
        ground.say("mission_request_int", number, 1, seq)

        def item(seq: int = seq) -> Any:
            return next((m for m in ground.heard("MISSION_ITEM_INT", number)[::-1] if m.seq == seq), None)

        read.append(wait_for(f"item {seq} comes", item, 10, 0.005))
    ground.say("mission_ack", number, 1, 0)
    return read


def upload(ground: Ground, number: int, places: list[tuple[int, int, float]]) -> int:
    """Sends a mission as ground stations do; the type of its acknowledgement."""
    before, asked = len(ground.heard("MISSION_ACK", number)), 0
    requests = len(ground.heard("MISSION_REQUEST_INT", number))
    ground.say("mission_count", number, 1, len(places))

    def acknowledged() -> list[Any] | None:
        nonlocal asked
        for m in ground.heard("MISSION_REQUEST_INT", number)[requests + asked :]:
            asked += 1
            x, y, z = places[m.seq]
            home = m.seq == 0
            ground.say(
                *("mission_item_int", number, 1, m.seq, 0 if home else 3, 16, 0, 1, 0, 0, 0, 0, x, y, z, 0)
            )
        return ground.heard("MISSION_ACK", number)[before:] or None

    return int(wait_for("it is acknowledged", acknowledged, 60, 0.01)[0].type)


def test_missions_are_written_by_one_and_read_by_all_without_another_transfer(
    server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    users = [
        granted(server, api, "planner", ids(copters[:1])),
        granted(server, api, "viewer", ids(copters[:1])),
    ]
    grounds = [attach(user) for user in users] + [attach(users[1], system_id=250 + n) for n in range(3)]
    number = next(iter(grounds[0].wait_vehicles(1)))
    places = [(473977000 + 100 * n, 85456000 + 100 * n, 20.0) for n in range(201)]
    assert upload(grounds[0], number, places) == 0
    wait_for("it is read back", lambda: len(api.drone(copters[0].id)["mission"]["items"] or []) == 200)
    read = len(copters[0].tap.heard("MISSION_ITEM_INT", up=True))
    for ground in grounds:
        (own,) = ground.wait_vehicles(1)
        assert [(m.x, m.y, m.z) for m in items(ground, own)[1:]] == places[1:]
    # The cloud itself looks once more whether all is as it was.
    assert len(copters[0].tap.heard("MISSION_ITEM_INT", up=True)) <= read + len(places)


def test_a_viewer_writes_no_mission_and_what_would_be_lost_is_refused(
    server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    viewer = attach(granted(server, api, "viewer", ids(copters[:1])))
    (number,) = viewer.wait_vehicles(1)
    assert upload(viewer, number, [(473977000, 85456000, 20.0)] * 2) == mavlink.MAV_MISSION_DENIED

    planner = attach(granted(server, api, "planner", ids(copters[:1])))
    (number,) = planner.wait_vehicles(1)
    planner.say("mission_count", number, 1, 1)
    wait_for("it asks", lambda: planner.heard("MISSION_REQUEST_INT", number))
    planner.say(*("mission_item_int", number, 1, 0, 3, 16, 0, 1, 0, 0, 0, 0, 473977000, 85456000, 20))
    wait_for("only a home clears it", lambda: planner.heard("MISSION_ACK", number))
    assert planner.heard("MISSION_ACK", number)[0].type == mavlink.MAV_MISSION_ACCEPTED


def missing(ground: Ground, number: int) -> list[int] | None:
    """Places in the list of parameters that did not come; None as long as nothing came."""
    values = ground.heard("PARAM_VALUE", number)
    there = {m.param_index for m in values}
    return [index for index in range(values[0].param_count) if index not in there] if values else None


def complete(ground: Ground, number: int) -> bool:
    return missing(ground, number) == []


def load(ground: Ground, number: int) -> Callable[[], bool]:
    """Goes on with loading all parameters as ground stations do by UDP, where a burst may find no room at the
    receiver: what is missing when nothing more comes is asked for again; true when nothing is."""
    count, since = 0, time.monotonic()

    def go_on() -> bool:
        nonlocal count, since
        now = len(ground.heard("PARAM_VALUE", number))
        if now > count:
            count, since = now, time.monotonic()
        gaps = missing(ground, number)
        if gaps and time.monotonic() - since > 1:
            since = time.monotonic()
            for index in gaps[:GAPS_AT_ONCE]:
                ground.say("param_request_read", number, 1, b"", index)
        return complete(ground, number)

    return go_on


def test_five_clients_load_all_parameters_and_the_vehicle_is_read_once(
    server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    users = [granted(server, api, "operator", ids(copters[1:])) for _ in range(2)]
    users.append(granted(server, api, "viewer", ids(copters[1:])))
    by_udp, *by_tcp = (attach(users[n % 3], system_id=251 + n, tcp=n > 0) for n in range(5))
    for ground in (by_udp, *by_tcp):
        (number,) = ground.wait_vehicles(1)
        ground.say("param_request_list", number, 1)
    (number,) = by_udp.vehicles()
    wait_for("all parameters came by UDP", load(by_udp, number), 60)
    for ground in by_tcp:
        (number,) = ground.vehicles()
        # By TCP nothing is lost: none of these asks twice.
        wait_for("all parameters came by TCP", partial(complete, ground, number), 60)
    for ground in (by_udp, *by_tcp):
        assert ground.heard("PARAM_VALUE")[0].param_count >= PARAMETERS
    assert len(copters[1].tap.heard("PARAM_REQUEST_LIST", up=False)) == 1


def test_a_parameter_is_set_by_who_may_and_told_as_it_is_to_others(
    server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    for role, value in (("operator", 2_100.0), ("viewer", 2_100.0)):
        ground = attach(granted(server, api, role, ids(copters[1:])))
        (number,) = ground.wait_vehicles(1)
        wanted = value if role == "operator" else 900.0
        ground.say("param_set", number, 1, b"RTL_ALT", wanted, mavlink.MAV_PARAM_TYPE_REAL32)
        wait_for("it is answered", partial(ground.heard, "PARAM_VALUE", number), 30)
        last = ground.heard("PARAM_VALUE", number)[-1]
        assert (last.param_id, last.param_value) == ("RTL_ALT", value)
    sent = [h.message for h in copters[1].tap.heard("PARAM_SET", up=False)]
    assert {m.param_value for m in sent} == {2_100.0}


def every_message(number: int) -> list[Any]:
    """One of each kind that the dialect has, addressed to that system, with zeros else."""
    made = []
    for kind in mavlink.mavlink_map.values():
        if kind.id < 0 or kind.id == mavlink.MAVLINK_MSG_ID_SETUP_SIGNING:
            continue
        counts = dict(zip(kind.ordered_fieldnames, kind.array_lengths, strict=True))
        fields: dict[str, Any] = {}
        for name, form in zip(kind.fieldnames, kind.fieldtypes, strict=True):
            fields[name] = b"" if form == "char" else [0] * counts[name] if counts[name] > 1 else 0
        fields |= {name: number for name in kind.fieldnames if name == "target_system"}
        fields |= {name: 1 for name in kind.fieldnames if name == "target_component"}
        made.append(kind(**fields))
    return made


COMMANDS = sorted(
    number
    for name, number in vars(mavlink).items()
    if name.startswith("MAV_CMD_") and isinstance(number, int) and number not in (0, 31_000)
)


@pytest.mark.parametrize("who", ["stranger", "viewer", "operator without control"])
def test_nothing_of_who_may_not_command_reaches_the_vehicle(
    who: str, server: Server, api: Api, copters: list[Copter], attach: Attach
) -> None:
    copter = copters[0]
    holder = granted(server, api, "operator", ids([copter]))
    assert holder.api.call("POST", f"/drones/{copter.id}/control/take").ok
    role = "viewer" if who == "viewer" else "operator"
    user = granted(server, api, role, ids([copter]))
    number = next(iter(attach(user, tcp=False, system_id=240).wait_vehicles(1)))
    ground = attach(None if who == "stranger" else user)
    if who != "stranger":
        ground.wait_vehicles(1)
    told = copter.told()
    for message in every_message(number):
        ground.send(message)
    for command_number in COMMANDS:
        ground.say("command_long", number, 1, command_number, 0, *([0.0] * 7))
        ground.say("command_int", number, 1, 3, command_number, 0, 0, 0, 0, 0, 0, 0, 0, 10)
    if who == "stranger":
        assert ground.messages == []
    else:
        wait_for("the last one is answered", lambda: _last_answered(ground), 60)
    assert [one for one in copter.told()[len(told) :] if one != "PARAM_REQUEST_LIST"] == []
    assert holder.api.call("DELETE", f"/drones/{copter.id}/control").ok


def _last_answered(ground: Ground) -> bool:
    return any(m.command == COMMANDS[-1] for m in ground.heard("COMMAND_ACK"))
