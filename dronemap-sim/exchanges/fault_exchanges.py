"""Fail-safes and faults."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from flying import airborne, arm, arrived, climb_to, disarmed, go_to, north_of_here, ready, start
from missions import fly_square, upload
from vehicle_link import VehicleLink


def battery_low(link: VehicleLink) -> None:
    """The battery falls to 11 V (low 11.5 V → RTL): home, landed; then arming is refused."""
    airborne(link)
    start(link)
    link.set_parameter("SIM_BATT_VOLTAGE", 11.0)
    disarmed(link, 180)
    link.pump_for(8)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.pump_for(3)


def battery_critical(link: VehicleLink) -> None:
    """Low → RTL, a while later critical → LAND on the spot."""
    airborne(link)
    target = north_of_here(link, 60)
    go_to(link, target, 20)
    arrived(link, target)
    start(link)
    link.set_parameter("SIM_BATT_VOLTAGE", 11.0)
    link.wait_until("RTL", lambda: link.mode == "RTL", 30)
    link.pump_for(4)
    link.set_parameter("SIM_BATT_VOLTAGE", 10.0)
    disarmed(link, 180)


def battery_low_by_default(link: VehicleLink) -> None:
    """The default action for a low battery: only a warning."""
    airborne(link)
    start(link)
    link.set_parameter("SIM_BATT_VOLTAGE", 10.2)
    link.pump_for(20)


def ground_station_lost(link: VehicleLink) -> None:
    """Heartbeats stop for 15 s and come back."""
    airborne(link)
    start(link)
    link.pump_for(3)
    link.heartbeats_on = False
    link.pump_for(15)
    link.heartbeats_on = True
    disarmed(link, 180)


def ground_station_lost_by_default(link: VehicleLink) -> None:
    """Heartbeats stop for 15 s with the default setting: nothing happens."""
    airborne(link)
    start(link)
    link.pump_for(3)
    link.heartbeats_on = False
    link.pump_for(15)
    link.heartbeats_on = True
    link.pump_for(3)


def ground_station_lost_in_auto(link: VehicleLink) -> None:
    """Heartbeats stop for 15 s while AUTO flies and the vehicle is told to continue (FS_OPTIONS 2)."""
    ready(link)
    upload(link, fly_square(link.position)[:5])
    climb_to(link, 20)
    link.set_mode_and_acknowledge("AUTO")
    link.wait_until("item 2", lambda: link.last["MISSION_CURRENT"].seq == 2, 30)
    start(link)
    link.pump_for(3)
    link.heartbeats_on = False
    link.pump_for(15)
    link.heartbeats_on = True
    link.pump_for(3)


def motor_failure(link: VehicleLink) -> None:
    """One motor of four stops at 30 m."""
    link.send_and_acknowledge(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, mavlink.MAVLINK_MSG_ID_ATTITUDE, 100_000)
    airborne(link, 30)
    start(link)
    link.set_parameter("SIM_ENGINE_MUL", 0)
    link.pump_for(45)


def gps_lost(link: VehicleLink) -> None:
    """GPS gone in GUIDED, back 20 s later."""
    airborne(link)
    start(link)
    link.set_parameter("SIM_GPS_DISABLE", 1)
    link.pump_for(20)
    link.set_parameter("SIM_GPS_DISABLE", 0)
    disarmed(link, 180)


def gps_missing_on_ground(link: VehicleLink) -> None:
    """GPS gone before arming."""
    ready(link)
    link.set_parameter("SIM_GPS_DISABLE", 1)
    link.pump_for(12)
    start(link)
    link.set_mode_and_acknowledge("GUIDED")
    arm(link)
    link.pump_for(3)
