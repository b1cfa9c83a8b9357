"""Exchanges with an ArduPlane."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import ACCEPTED, arm, disarmed, go_to, start, take_off
from missions import clear, download
from plane_flying import (
    PlaneItem,
    at_item,
    circuit,
    from_the_ground,
    land,
    offset,
    reposition,
    take_off_by_mode,
    takeoff,
    upload_plane,
    waypoint,
)
from vehicle_link import VehicleLink

SPEED_AIR = 0.0
SPEED_GROUND = 1.0


def arming_refused(link: VehicleLink) -> None:
    """From power-up: arm asked every 7 s until it is granted; then nothing is done."""
    start(link)
    link.request_rates()
    for _ in range(20):
        if link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1) == ACCEPTED:
            break
        link.pump_for(7)
    link.pump_for(15)
    link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
    link.pump_for(2)


def modes_on_ground(link: VehicleLink) -> None:
    """Modes on the ground, arming in each; an unknown one; AUTO without a mission; the older SET_MODE."""
    from_the_ground(link)
    for name in ("MANUAL", "STABILIZE", "FBWA", "CRUISE", "CIRCLE", "LOITER", "GUIDED", "RTL", "AUTO"):
        link.set_mode_and_acknowledge(name)
        link.pump_for(1)
        if arm(link) == ACCEPTED:
            link.pump_for(1)
        link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
        link.pump_for(1)
    for name in ("QLOITER", "QLAND", "QRTL"):
        link.set_mode_and_acknowledge(name)
        link.pump_for(1)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MODE, mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, 99)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MODE, 0, 11)
    link.send(mavlink.MAVLink_set_mode_message(link.system_id, 1, 11))
    link.pump_for(2)


def commands_on_ground(link: VehicleLink) -> None:
    """Take-off, landing, go-to, pause, change of speed, start of a mission and going round, on the ground."""
    home = from_the_ground(link)
    take_off(link, 40)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_LAND)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 0)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, SPEED_AIR, 15, -1)
    link.send_and_acknowledge(mavlink.MAV_CMD_CONDITION_YAW, 90, 20, 1, 0)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_GO_AROUND, 40)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_LAND_START)
    link.send_and_acknowledge(31999)
    reposition(link, offset(home, 200, 0), 50)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_REPOSITION, -1, 1, 0, 0, 0, 0, 20)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_LOITER_UNLIM)
    link.pump_for(1)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    link.pump_for(1)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    link.pump_for(3)


def commands_in_flight(link: VehicleLink) -> None:
    """The same in flight, in LOITER and in GUIDED; disarming is refused."""
    home = from_the_ground(link)
    take_off_by_mode(link)
    link.set_mode_and_acknowledge("LOITER")
    link.pump_for(2)
    for name in ("LOITER", "GUIDED"):
        link.set_mode_and_acknowledge(name)
        link.pump_for(1)
        take_off(link, 40)
        link.send_and_acknowledge(mavlink.MAV_CMD_NAV_LAND)
        link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 0)
        link.send_and_acknowledge(mavlink.MAV_CMD_DO_PAUSE_CONTINUE, 1)
        link.send_and_acknowledge(mavlink.MAV_CMD_CONDITION_YAW, 90, 20, 1, 0)
        link.send_and_acknowledge(mavlink.MAV_CMD_DO_GO_AROUND, 40)
        link.send_and_acknowledge(mavlink.MAV_CMD_DO_LAND_START)
        link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, SPEED_AIR, 15, -1)
        link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, SPEED_AIR, 3, -1)
        link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, SPEED_GROUND, 14, -1)
        link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0)
        reposition(link, offset(home, 200, 0), 50)
        reposition(link, (950_000_000, 0), 50)
        link.pump_for(2)
    for name in ("AUTO", "QLOITER", "TAKEOFF"):
        link.set_mode_and_acknowledge(name)
        link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MODE, mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, 99)
    link.pump_for(2)


def mission_upload(link: VehicleLink) -> None:
    """Holds of half seconds, loiter items, items that it does not know; read back."""
    home = from_the_ground(link)
    known = [
        takeoff(40, 12.5),
        waypoint(300, 0, 60, 2.5),
        waypoint(300, 300, 60, 300),
        PlaneItem(int(mavlink.MAV_CMD_NAV_LOITER_TIME), 300, 0, 60, (12.5, 0, 80, 1)),
        PlaneItem(int(mavlink.MAV_CMD_NAV_LOITER_TURNS), 300, 0, 60, (1.5, 0, 80, 1)),
        PlaneItem(int(mavlink.MAV_CMD_NAV_LOITER_TO_ALT), 300, 0, 60, (0, 80, 0, 1)),
        PlaneItem(int(mavlink.MAV_CMD_NAV_LOITER_UNLIM), 300, 0, 60, (0, 0, 80, 0)),
        PlaneItem(int(mavlink.MAV_CMD_NAV_DELAY), params=(2.5, -1, -1, -1), placed=False),
        PlaneItem(int(mavlink.MAV_CMD_DO_CHANGE_SPEED), params=(0, 15.5, -1, 0), placed=False),
        land(0, 0, placed=False),
    ]
    upload_plane(link, known, home)
    download(link)
    for unknown in (
        mavlink.MAV_CMD_DO_SET_ROI_LOCATION,
        mavlink.MAV_CMD_DO_SET_ROI_NONE,
        mavlink.MAV_CMD_DO_SET_ROI,
        mavlink.MAV_CMD_NAV_SPLINE_WAYPOINT,
        mavlink.MAV_CMD_CONDITION_YAW,
        mavlink.MAV_CMD_NAV_VTOL_TAKEOFF,
        mavlink.MAV_CMD_NAV_VTOL_LAND,
        31000,
    ):
        upload_plane(link, [takeoff(40), PlaneItem(int(unknown), 300, 0, 60)], home)
    download(link)
    clear(link)
    link.pump_for(1)


def takeoff_mode(link: VehicleLink) -> None:
    """TAKEOFF asked for, armed: it climbs straight ahead and circles; LOITER; RTL: it circles at home."""
    from_the_ground(link)
    link.set_mode_and_acknowledge("TAKEOFF")
    link.pump_for(2)
    arm(link)
    link.wait_until("45 m", lambda: link.altitude_meters > 45, 90)
    link.pump_for(20)
    link.set_mode_and_acknowledge("LOITER")
    link.pump_for(20)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    link.pump_for(60)


def guided(link: VehicleLink) -> None:
    """DO_REPOSITION in another mode without and with its flag; circles there; a height alone; a setpoint in vain."""
    home = from_the_ground(link)
    take_off_by_mode(link)
    reposition(link, offset(home, 400, 0), 70)
    link.pump_for(2)
    reposition(link, offset(home, 400, 0), 70, flags=1)
    link.pump_for(50)
    reposition(link, offset(home, 400, 0), 90, radius=100)
    link.pump_for(20)
    go_to(link, offset(home, -400, 0), 60)
    link.pump_for(20)
    link.set_mode_and_acknowledge("GUIDED")
    link.pump_for(5)


def speed(link: VehicleLink) -> None:
    """Other airspeeds in GUIDED: faster, out of range, back to the default."""
    home = from_the_ground(link)
    take_off_by_mode(link)
    reposition(link, offset(home, 0, 1500), 60, flags=1)
    link.pump_for(3)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, SPEED_AIR, 17, -1)
    link.pump_for(12)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, SPEED_AIR, 60, -1)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, SPEED_AIR, 12, -1)
    link.pump_for(12)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, SPEED_AIR, -2, -1)
    link.pump_for(10)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_CHANGE_SPEED, SPEED_GROUND, 12, -1)
    link.pump_for(5)


def mission_flight(link: VehicleLink) -> None:
    """AUTO and armed on the ground: take-off, waypoints, DO_LAND_START, approach, LAND, landed, disarmed."""
    home = from_the_ground(link)
    upload_plane(link, circuit(), home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    disarmed(link, 300)
    link.pump_for(3)


def mission_not_armable(link: VehicleLink) -> None:
    """The same mission with the default settings (RTL_AUTOLAND 0): its DO_LAND_START keeps it from arming."""
    home = from_the_ground(link)
    upload_plane(link, circuit(), home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    link.pump_for(2)


def mission_to_rtl(link: VehicleLink) -> None:
    """A mission that ends with RTL: it circles at home and stays in RTL; arming again is not asked for."""
    home = from_the_ground(link)
    items = [
        takeoff(40),
        waypoint(300, 0, 60),
        PlaneItem(int(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH), placed=False),
    ]
    upload_plane(link, items, home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    link.wait_until("RTL", lambda: link.mode == "RTL", 120)
    link.pump_for(60)


def mission_to_its_end(link: VehicleLink) -> None:
    """A mission whose last item is a waypoint: RTL; a jump back into it from AUTO."""
    home = from_the_ground(link)
    upload_plane(link, [takeoff(40), waypoint(300, 0, 60), waypoint(300, 300, 60)], home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    link.wait_until("RTL", lambda: link.mode == "RTL", 120)
    link.pump_for(10)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_SET_MISSION_CURRENT, 2)
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_MISSION_START)
    at_item(link, 3, 60)
    link.pump_for(2)
    link.set_mode_and_acknowledge("LOITER")
    link.pump_for(5)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(5)
    clear(link)
    link.pump_for(5)


def loiter_items(link: VehicleLink) -> None:
    """A mission with a loiter by time, by turns and to a height, and one for ever."""
    home = from_the_ground(link)
    take_off_by_mode(link)
    loiters = [
        PlaneItem(int(mavlink.MAV_CMD_NAV_LOITER_TIME), 300, 0, 60, (10, 0, 0, 0)),
        PlaneItem(int(mavlink.MAV_CMD_NAV_LOITER_TURNS), 300, 400, 60, (1, 0, 0, 0)),
        PlaneItem(int(mavlink.MAV_CMD_NAV_LOITER_TO_ALT), -100, 400, 80, (0, 0, 0, 0)),
        PlaneItem(int(mavlink.MAV_CMD_NAV_LOITER_UNLIM), -100, 0, 80, (0, 0, 0, 0)),
    ]
    upload_plane(link, loiters, home)
    link.set_mode_and_acknowledge("AUTO")
    at_item(link, 4, 240)
    link.pump_for(40)


def go_around(link: VehicleLink) -> None:
    """DO_GO_AROUND on the final approach: it climbs, flies the approach again and lands."""
    home = from_the_ground(link)
    upload_plane(link, circuit(), home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    at_item(link, 8, 240)
    link.pump_for(3)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_GO_AROUND, 40)
    disarmed(link, 300)


def land_start(link: VehicleLink) -> None:
    """DO_LAND_START as a command from LOITER: AUTO at the approach, landed, disarmed."""
    home = from_the_ground(link)
    upload_plane(link, circuit(), home)
    take_off_by_mode(link)
    link.set_mode_and_acknowledge("LOITER")
    link.pump_for(2)
    link.send_and_acknowledge(mavlink.MAV_CMD_DO_LAND_START)
    disarmed(link, 300)


def land_nowhere(link: VehicleLink) -> None:
    """A mission whose LAND has the place 0/0, right after a waypoint."""
    home = from_the_ground(link)
    upload_plane(link, [takeoff(40), waypoint(400, 0, 50), land(0, 0, placed=False)], home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    disarmed(link, 240)


def rtl_lands(link: VehicleLink) -> None:
    """RTL with RTL_AUTOLAND 1 and a landing in the mission: home, and then AUTO from DO_LAND_START to disarmed."""
    home = from_the_ground(link)
    upload_plane(link, circuit(), home)
    take_off_by_mode(link)
    reposition(link, offset(home, 300, 300), 90, flags=1)
    link.pump_for(25)
    link.send_and_acknowledge(mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    disarmed(link, 300)


def ground_station_lost(link: VehicleLink) -> None:
    """Heartbeats stop for 30 s in GUIDED (FS_GCS_ENABL 1, FS_LONG_ACTN 1) and come back."""
    from_the_ground(link)
    take_off_by_mode(link)
    link.set_mode_and_acknowledge("GUIDED")
    link.pump_for(3)
    link.pump_for(3)
    link.heartbeats_on = False
    link.pump_for(30)
    link.heartbeats_on = True
    link.pump_for(20)


def ground_station_lost_by_default(link: VehicleLink) -> None:
    """Heartbeats stop for 30 s in LOITER with the default settings: nothing happens."""
    from_the_ground(link)
    take_off_by_mode(link)
    link.set_mode_and_acknowledge("LOITER")
    link.pump_for(3)
    link.pump_for(3)
    link.heartbeats_on = False
    link.pump_for(30)
    link.heartbeats_on = True
    link.pump_for(5)


def ground_station_lost_in_auto(link: VehicleLink) -> None:
    """Heartbeats stop in AUTO with the fail-safe on and its action continue (FS_LONG_ACTN 0)."""
    home = from_the_ground(link)
    upload_plane(link, circuit(), home)
    link.set_mode_and_acknowledge("AUTO")
    link.pump_for(1)
    arm(link)
    at_item(link, 2, 90)
    link.pump_for(3)
    link.heartbeats_on = False
    link.pump_for(30)
    link.heartbeats_on = True
    link.pump_for(10)


def battery_low(link: VehicleLink) -> None:
    """The battery falls to 11 V in LOITER (low 11.5 V → RTL)."""
    from_the_ground(link)
    take_off_by_mode(link)
    link.set_mode_and_acknowledge("LOITER")
    link.pump_for(2)
    link.set_parameter("SIM_BATT_VOLTAGE", 11.0)
    link.wait_until("RTL", lambda: link.mode == "RTL", 30)
    link.pump_for(10)
