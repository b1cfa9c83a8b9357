"""Judges follows by where vehicles truly were: `python -m dronemap_e2e.follow_judge TRUTH.json`.

The file holds the fences in metres, the lowest height above each home, what drones are to keep from each
other, and for each vehicle rows of seconds, east, north, up and height above its home.
"""

import json
import math
import sys
from pathlib import Path
from typing import Any

from .trajectories import Fix, Track

STRIDE_SECONDS = 0.1
# Who is below the lowest height since its take-off goes nowhere but up.
RISES_WITHIN_METRES = 3.0


def judged(truth: dict[str, Any]) -> dict[str, Any]:
    """The least margin of each measure; negative: somebody went beyond."""
    tracks = {int(name): Track([Fix(*row) for row in rows]) for name, rows in truth["tracks"].items()}
    starts = [track.fixes[0].seconds for track in tracks.values()]
    ends = [track.fixes[-1].seconds for track in tracks.values()]
    fence = height = rising = apart = (math.inf, 0.0, "")
    risen: set[int] = set()
    looks = 0
    seconds = min(starts)
    while seconds <= max(ends):
        here = [(name, at) for name, track in tracks.items() if (at := track.at(seconds)) is not None]
        looks += len(here)
        for name, at in here:
            fence = min(fence, (_to_fence(truth, at), seconds, str(name)))
            over = at.above_home - truth["lowest"]
            if over >= 0:
                risen.add(name)
            if name in risen:
                height = min(height, (over, seconds, str(name)))
            else:
                began = tracks[name].fixes[0]
                strays = math.hypot(at.east - began.east, at.north - began.north)
                rising = min(rising, (RISES_WITHIN_METRES - strays, seconds, str(name)))
        for number, (name, one) in enumerate(here):
            for other, there in here[number + 1 :]:
                if abs(one.up - there.up) < truth["separation"]["height"]:
                    metres = math.hypot(one.east - there.east, one.north - there.north)
                    left = metres - truth["separation"]["metres"]
                    apart = min(apart, (left, seconds, f"{name} and {other}"))
        seconds += STRIDE_SECONDS
    found = {"fence": fence, "height": height, "rising": rising, "apart": apart}
    named = {what: dict(zip(("left", "seconds", "who"), one, strict=True)) for what, one in found.items()}
    return named | {"vehicles": len(tracks), "looks": looks}


def _to_fence(truth: dict[str, Any], at: Fix) -> float:
    """Metres to the nearest edge; negative: beyond it."""
    west, south, east, north = truth["inside"]
    left = min(at.east - west, east - at.east, at.north - south, north - at.north)
    for disc_east, disc_north, radius in truth["discs"]:
        left = min(left, math.hypot(at.east - disc_east, at.north - disc_north) - radius)
    return float(left)


if __name__ == "__main__":
    print(json.dumps(judged(json.loads(Path(sys.argv[1]).read_text()))))
