"""Vehicles that were reported to be misunderstood, as scripts of the test data play them."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from dronemap_e2e.server import Server

DATA = os.environ.get("DRONEMAP_TEST_DATA")
LONGEST_SECONDS = 240

# By script: what its output has, in this order.
SEEN: dict[str, list[str]] = {
    "03b_companion_first": [
        r"both speak: GUIDED True \{'latitude': 47\.3977.* live",
        r"sent to components \{\('COMMAND_LONG', 1\)\}",
        r"silent for +0 s.*\('live', 'GUIDED', True, True\)",
    ],
    "05c_parameter_hole": [
        r"59 of 60 parameters were read and can be used\. .* number 17 \(after P016\)",
        r"list then: \S+ 59 59",
        r'set another one: 200 \{"result": "succeeded"',
        r"file: P000,0",
    ],
    "19_rally_frames": [
        r'"altitude": 50\.0, "altitudeReference": "home".*560\.0.*"amsl".*60\.0.*"terrain"',
        r"on board then \(frame, z\): \[\(3, 50\.0\), \(0, 560\.0\), \(10, 60\.0\)\]",
    ],
    "19b_outlet_rally": [
        r"rally read .* -> \[\(3, 5100, 50\.0\), \(0, 5100, 560\.0\), \(10, 5100, 60\.0\)\]",
        r"fence read .* -> \[\(3, 5000, 50\.0\), (\(\d, 5001, 0\.0\)(, )?){3}\]",
        r"frame 0 560\.0 -> \(0, \[\]\) on board \[\(0, 560\.0\)\]",
        r"frame 10 60\.0 -> \(0, \[\]\) on board \[\(10, 60\.0\)\]",
        r"frame 6 55\.0 -> \(0, \[\]\) on board \[\(3, 55\.0\)\]",
        r"count says 5, .* -> \(3, \['Items 1 to 4",
        r"polygon of 120 corners -> \(0, \[\]\) on board 120",
        r"circle of radius 0\.5 m -> \(0, \[\]\) on board 1 \[\(5004, 0\.5\)\]",
    ],
    "min_battery_14_cells": [r"'percent': 80, 'volts': 57\.4, 'amps': 5\.0"],
    "min_fence_left_out": [r"'succeeded'.*\[\('polygon', True\), \('circle', False\)\]"],
    "min_float_only_upload": [r"neither as MISSION_ITEM_INT nor as MISSION_ITEM.*'float': \d"],
    "min_high_latency2": [r"(live RTL 47\.3987 \{.*\}\s+){4}"],
    "min_int32_lost_bit": [r"'failed'.*would become 1073741824.*nothing was changed\.'.* 33$"],
    "min_log_hole": [r"'succeeded'.* 69$"],
    "min_statustext_id_after_reboot": [r"'first boot\.+end', 'second boot\.+end'\]"],
    "min_statustext_two_components": [r"'autopilot\.+end', 'companion\.+end'\]"],
}


@pytest.mark.skipif(DATA is None, reason="DRONEMAP_TEST_DATA is not set: scripts of cases are not run")
@pytest.mark.parametrize("script", SEEN)
def test_a_reported_vehicle_is_understood(server: Server, tmp_path: Path, script: str) -> None:
    """End to end because the vehicle is another maker's code, before a server as it ships."""
    cases = Path(str(DATA)) / "cases"
    key = tmp_path / "key"
    key.write_text(server.local_key())
    # The outlet's port stands in the script.
    (tmp_path / "case.py").write_text(
        (cases / f"{script}.py").read_text().replace(":14560", f":{server.outlet_udp_port}")
    )
    run = subprocess.run(
        [sys.executable, tmp_path / "case.py"],
        env=os.environ
        | {
            "DM_KEY_FILE": str(key),
            "DM_API": f"{server.address}/api/v1",
            "DM_UDP": f"127.0.0.1:{server.udp_port}",
            "PYTHONPATH": str(cases),
            "PYTHONDONTWRITEBYTECODE": "1",
        },
        capture_output=True,
        text=True,
        timeout=LONGEST_SECONDS,
        check=False,
    )
    place = 0
    for pattern in SEEN[script]:
        found = re.compile(pattern, re.MULTILINE | re.DOTALL).search(run.stdout, place)
        assert found, f"{pattern} is not in:\n{run.stdout[place:]}\n{run.stderr}"
        place = found.start()
