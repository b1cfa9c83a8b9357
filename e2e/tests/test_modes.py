"""Every mode that pymavlink knows of an autopilot has the same name in the table that other tests go by."""

from pymavlink import mavutil
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from dronemap_e2e.server import ROOT

TABLE = ROOT / "dronemap-proxy/src/test/resources/org/dronemap/proxy/mavlink/translate/modes.txt"

ARDUPILOT, PX4 = mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA, mavlink.MAV_AUTOPILOT_PX4
MODES = {
    (ARDUPILOT, mavlink.MAV_TYPE_QUADROTOR): mavutil.mode_mapping_acm,
    (ARDUPILOT, mavlink.MAV_TYPE_FIXED_WING): mavutil.mode_mapping_apm,
    (ARDUPILOT, mavlink.MAV_TYPE_GROUND_ROVER): mavutil.mode_mapping_rover,
    (ARDUPILOT, mavlink.MAV_TYPE_SUBMARINE): mavutil.mode_mapping_sub,
    # px4_map holds (base mode, main mode, sub mode) by name.
    (PX4, mavlink.MAV_TYPE_QUADROTOR): {
        (main << 16) | (sub << 24): name for name, (_, main, sub) in mavutil.px4_map.items()
    },
}


def test_mode_table_has_pymavlink_names() -> None:
    """End to end because pymavlink itself must say which modes it knows and what it calls them."""
    table: dict[tuple[int, int], dict[int, str]] = {}
    for line in TABLE.read_text(encoding="ascii").splitlines():
        if not line.startswith("#"):
            autopilot, kind, number, name = line.split(" ")
            table.setdefault((int(autopilot), int(kind)), {})[int(number)] = name

    for vehicle, modes in MODES.items():
        assert len(modes) > 8 and table[vehicle] == modes, vehicle
