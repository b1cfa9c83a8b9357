"""Checks the report of `bench/follow`."""

import json
from pathlib import Path

import pytest

from dronemap_bench.following import gpx, report
from dronemap_bench.following.report import EXACT, FORESEEN, LAST_FIX, PLACE, SIMULATED, SLOW, Row

ABOUT = {"at": "now", "java": "java", "revision": "abc", "processor": "two"}
TRACK = """<gpx xmlns="http://www.topografix.com/GPX/1/1"><trk><trkseg>
<trkpt lat="47.0" lon="8.0"><time>2026-05-01T10:00:00Z</time></trkpt>
<trkpt lat="47.0001" lon="8.0"><time>2026-05-01T10:00:08Z</time></trkpt>
<trkpt lat="47.0001" lon="8.0"><time>2026-05-01T10:00:08Z</time></trkpt>
<trkpt lat="47.0001" lon="8.0002"><ele>3</ele></trkpt>
<trkpt lat="47.0001" lon="8.0002"><time>2026-05-01T10:00:20.5Z</time></trkpt>
</trkseg></trk></gpx>"""


def row(walk: str, mean: float, noise: str = EXACT, way: str = FORESEEN, vehicle: str = SIMULATED) -> Row:
    quantiles = [mean * percent / 50 for percent in range(101)]
    return Row(walk, SLOW, noise, way, mean, mean, 3.8, quantiles, 20.0, 0.5, [mean, mean], vehicle)


def test_limits_are_kept_or_missed() -> None:
    rows = [
        row("walking", 0.5),
        row("walking", 4.9, PLACE),
        row("running", 1),
        row("running", 2, way=LAST_FIX),
    ]
    table = report.table(ABOUT, 3, rows)
    assert "| walking, exact phone: mean | 0.50 | 1.00 | kept |" in table
    assert "| walking, phone 3 m wandering, 0.5 m white: mean | 4.90 | 4.80 | **missed** |" in table
    assert "| running: foretold, share of not foretold | 0.50 | 0.70 | kept |" in table


def test_real_autopilot_has_limits_column_and_curve() -> None:
    rows = [row("walking", 0.5), row("running", 0.7), row("walking", 1.2, vehicle="ArduCopter 4.5.6")]
    table = report.table(ABOUT, 3, rows)
    assert "| walking, exact phone: mean | 0.50 | 1.00 | kept |" in table
    assert "| walking, exact phone, ArduCopter 4.5.6: mean | 1.20 | 1.00 | **missed** |" in table
    assert "| walking | 300 ms | exact | foretold | 0.50 | 0.95 | 0.50 | 3.80 | 1.20 (2.28) |" in table
    assert "| running | 300 ms | exact | foretold | 0.70 | 1.33 | 0.70 | 3.80 | – |" in table
    page = report.page(ABOUT, 3, rows)
    assert "foretold, ArduCopter 4.5.6" in page
    assert page.count("<polyline") == 6


def test_trial_line_parses_to_row(tmp_path: Path) -> None:
    one = row("walking", 0.5)
    report.write(tmp_path, "x", ABOUT, 3, [one])
    whole = json.loads((tmp_path / "x.json").read_text())
    assert report.parse(json.dumps(whole["rows"][0])) == one
    page = (tmp_path / "x.html").read_text()
    assert page.count("<svg") == 2
    assert page.count("<table>") == page.count("</table>") == 2


def test_gpx_track_becomes_seconds_and_metres() -> None:
    first, second, third = gpx.points(TRACK)
    assert first == (0, 0, 0)
    assert second == pytest.approx((8, 0, 11.12), abs=0.01)
    assert third == pytest.approx((20.5, 15.17, 11.12), abs=0.01)


def test_gpx_outliers_are_left_out() -> None:
    times = "".join(
        f'<trkpt lat="{47 + north / 111_195}" lon="8.0"><time>2026-05-01T10:00:{second:02}Z</time></trkpt>'
        for second, north in [(0, 0), (1, 4), (2, 90), (3, 94), (4, 98), (5, 102)]
    )
    assert [second for second, _, _ in gpx.points(f"<gpx>{times}</gpx>")] == [0, 1, 5]


def test_gpx_without_times_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "way.gpx"
    file.write_text("<gpx/>")
    with pytest.raises(SystemExit, match="no track with times"):
        gpx.written(file, tmp_path)
