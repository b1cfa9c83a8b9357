"""Steps that the exchanges share: getting ready, arming, climbing, going somewhere."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega as mavlink

from vehicle_link import VehicleLink

UNCHANGED = 65535  # RC_CHANNELS_OVERRIDE: leave this channel alone
ACCEPTED = int(mavlink.MAV_RESULT_ACCEPTED)
GLOBAL_RELATIVE = int(mavlink.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT)
READY_SECONDS = 90.0
POSITION_ONLY = 0b0000_1101_1111_1000  # SET_POSITION_TARGET_GLOBAL_INT: ignore all but the position
PLACE_SPEED_AND_YAW = 0b1001_1100_0000  # the same: ignore accelerations and the rate of turning
DEGREES_E7_PER_METER_NORTH = 1e7 / 111_319.5


def start(link: VehicleLink) -> None:
    """Everything before this is preparation."""
    if link.transcript is None:
        raise ValueError("no transcript to write to")
    link.clear_inbox()
    link.transcript.start()


def ready(link: VehicleLink) -> None:
    """Wait until the autopilot says that it would arm."""
    link.wait_until("ready to arm", lambda: link.ready, READY_SECONDS)


def arm(link: VehicleLink) -> int:
    """Ask to arm; wait for the HEARTBEAT to say so if it was accepted."""
    result = link.send_and_acknowledge(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1)
    if result == ACCEPTED:
        link.wait_until("armed", lambda: link.armed, 5)
    return result


def take_off(link: VehicleLink, altitude_meters: float) -> int:
    """Ask to take off; do not wait for the altitude."""
    return link.send_and_acknowledge(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, altitude_meters)


def climb_to(link: VehicleLink, altitude_meters: float) -> None:
    """GUIDED, arm, take off and wait for the altitude."""
    link.set_mode_and_acknowledge("GUIDED")
    link.wait_until("GUIDED", lambda: link.mode == "GUIDED", 5)
    arm(link)
    take_off(link, altitude_meters)
    link.wait_until("altitude", lambda: link.altitude_meters > altitude_meters - 0.5, 60)


def airborne(link: VehicleLink, altitude_meters: float = 20) -> None:
    """Ready, then up and steady."""
    ready(link)
    climb_to(link, altitude_meters)
    link.pump_for(3)


def disarmed(link: VehicleLink, seconds: float = 120) -> None:
    """Wait for the end of the flight and a little more."""
    link.wait_until("disarmed", lambda: not link.armed, seconds)
    link.pump_for(2)


def north_of_here(link: VehicleLink, meters: float) -> tuple[int, int]:
    """Latitude and longitude in degrees × 10⁷."""
    latitude, longitude = link.position
    return latitude + round(meters * DEGREES_E7_PER_METER_NORTH), longitude


def go_to(link: VehicleLink, target: tuple[int, int], altitude_meters: float) -> None:
    """SET_POSITION_TARGET_GLOBAL_INT, position alone, once."""
    link.send(
        mavlink.MAVLink_set_position_target_global_int_message(
            0,
            link.system_id,
            1,
            GLOBAL_RELATIVE,
            POSITION_ONLY,
            *target,
            altitude_meters,
            0,
            0,
            0,
            0,
            0,
            0,
            0,
            0,
        )
    )


def send_moving_setpoint(link: VehicleLink, place: tuple[int, int], north: float, yaw: float) -> None:
    """SET_POSITION_TARGET_GLOBAL_INT at 20 m: a place that moves north at so many m/s, and where to look (radians)."""
    link.send(
        mavlink.MAVLink_set_position_target_global_int_message(
            0,
            link.system_id,
            1,
            GLOBAL_RELATIVE,
            PLACE_SPEED_AND_YAW,
            *place,
            20,
            north,
            0,
            0,
            0,
            0,
            0,
            yaw,
            0,
        )
    )


def arrived(link: VehicleLink, target: tuple[int, int], seconds: float = 60) -> None:
    """Within a metre in latitude, and slow."""
    link.wait_until(
        "arrived",
        lambda: (
            abs(link.position[0] - target[0]) < DEGREES_E7_PER_METER_NORTH and link.last["VFR_HUD"].groundspeed < 0.3
        ),
        seconds,
    )
