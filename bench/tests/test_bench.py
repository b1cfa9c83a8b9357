"""Checks that the benchmark measures at all (short), and that the goals are met (soak)."""

import json
import os
from pathlib import Path

import pytest

from dronemap_bench import configurations, report
from dronemap_bench.__main__ import main
from dronemap_bench.configurations import Clients, Configuration, Impairment
from dronemap_bench.measure import measure

SMALL = Configuration(
    "small",
    "5 vehicles, 20 messages/s each, then 3 ground stations and a stuck one",
    5,
    20,
    seconds=6,
    warm_up=4,
    clients=Clients(3, stuck=1, settle_seconds=2),
)
BAD = Configuration(
    "bad",
    "5 vehicles over a bad network",
    5,
    20,
    seconds=6,
    warm_up=6,
    only_positions=True,
    impairment=Impairment(delay=200, jitter=50, loss=0.1, duplicate=0.1, seed=7),
)


@pytest.fixture
def short_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Makes runs of seconds compile less: no figure is compared here."""
    given = os.environ.get("JAVA_TOOL_OPTIONS", "")
    monkeypatch.setenv("JAVA_TOOL_OPTIONS", f"{given} -XX:TieredStopAtLevel=1")


@pytest.mark.usefixtures("short_runs")
def test_every_frame_sent_is_recorded_byte_for_byte() -> None:
    result = measure(SMALL)
    tlogs = result["tlogs"]
    assert (tlogs["recordings"], tlogs["complete"], tlogs["vehicles"]) == (5, 5, 5), result
    assert (tlogs["missing"], tlogs["late"], tlogs["foreign"]) == (0, 0, 0), result
    assert (tlogs["drops"], tlogs["brokenBytes"]) == (0, 0), result
    assert tlogs["found"] == tlogs["expected"] == 5 * (SMALL.steps() + 3), result
    assert result["live"] == 5
    assert result["stream"]["vehicles"] == 5
    assert result["stream"]["age"]["count"] > 0
    assert result["cpuMicrosPerMessage"] > 0
    assert (result["clients"]["clients"], result["clients"]["stuck"]) == (3, 1)
    assert 0.95 <= report.delivered(result) <= 1.05, result["clients"]


@pytest.mark.usefixtures("short_runs")
def test_impairment_delays_and_loses_messages() -> None:
    result = measure(BAD)
    assert result["tlogs"]["missing"] > 0, "nothing was lost on the way"
    assert result["tlogs"]["late"] > 0, "nothing was overtaken on the way"
    assert result["live"] == 5
    assert 150 <= report.millis(result, "50.0") <= 400


def test_results_are_written_as_table_plot_and_json(tmp_path: Path) -> None:
    percentiles = {p: 1500 for p in ["50.0", "75.0", "90.0", "95.0", "99.0", "99.9", "99.99"]}
    age = {"count": 1, "mean": 1.0, "percentiles": percentiles}
    one = {
        "name": "small",
        "what": "5 vehicles",
        "vehicles": 5,
        "rate": 20,
        "seconds": 6,
        "kernelDrops": 0,
        "sent": {"lateness": age},
        "stream": {"messages": 60, "age": age},
        "tlogs": {"found": 10, "expected": 10},
        "cpuPercentOfOneCore": 1.0,
        "cpuMicrosPerMessage": 2.0,
        "compilerMicrosPerMessage": 0.5,
        "kilobytesPerDrone": 3.0,
        "foreignLoadPercentOfMachine": 4.0,
    }
    about = {"at": "now", "processor": "2 x some", "java": "java", "revision": "r"}
    report.write(tmp_path, "x", {"machine": about, "configurations": [one]})
    assert json.loads((tmp_path / "x.json").read_text())["configurations"][0]["name"] == "small"
    assert "| small | 100 | 0 | 10 | 10 | 10 | 1.50 | 1.50 |" in (tmp_path / "x.md").read_text()
    assert (tmp_path / "x.svg").read_text().count("<polyline") == 1


def test_unknown_configuration_is_refused_by_name() -> None:
    with pytest.raises(SystemExit, match="There is no configuration nonsense"):
        main(["nonsense"])


@pytest.mark.soak
@pytest.mark.parametrize("name", ["fleet-100", "fleet-200"])
@pytest.mark.parametrize("again", [1, 2])
def test_large_fleet_loses_no_frame(name: str, again: int) -> None:
    result = measure(configurations.named([name])[0])
    assert result["sent"]["refused"] == 0, result
    assert result["kernelDrops"] == 0, result
    tlogs = result["tlogs"]
    assert (tlogs["missing"], tlogs["late"], tlogs["foreign"]) == (0, 0, 0), result


@pytest.mark.soak
def test_cpu_time_per_message_meets_goal() -> None:
    assert measure(configurations.named(["forwarding"])[0])["cpuMicrosPerMessage"] <= 8.8


@pytest.mark.soak
def test_position_latency_of_small_fleet_is_below_one_millisecond() -> None:
    result = measure(configurations.named(["latency"])[0])
    assert report.millis(result, "50.0") <= 1, result
    assert report.millis(result, "99.0") <= 5, result


@pytest.mark.soak
def test_two_thousand_vehicles_stay_live() -> None:
    many = configurations.named(["many"])[0].short(600)
    result = measure(many)
    assert result["live"] == 2000, result
    assert result["kernelDrops"] == 0, result


@pytest.mark.soak
@pytest.mark.parametrize("name", ["flood-broken", "flood-hostile"])
def test_flood_from_one_address_does_not_affect_other_vehicles(name: str) -> None:
    result = measure(configurations.named([name])[0])
    for calm, flooded in zip(result["calm"]["ageByHost"], result["stream"]["ageByHost"], strict=True):
        assert flooded["percentiles"]["99.0"] <= 2 * calm["percentiles"]["99.0"], result
    assert result["busyMegabytes"] <= result["middleMegabytes"] + 30, result


@pytest.mark.soak
@pytest.mark.parametrize("name", ["imatisse-1b", "imatisse-3b"])
def test_unstable_network_adds_little_more_than_its_delay(name: str) -> None:
    result = measure(configurations.named([name])[0])
    assert report.millis(result, "50.0") <= 500 + 10, result


@pytest.mark.soak
def test_fifty_ground_stations_and_a_stuck_one_do_not_slow_vehicle_path() -> None:
    result = measure(configurations.named(["attached"])[0])
    assert report.delivered(result) >= 0.999, result["clients"]
    calm, watched = (result[when]["age"]["percentiles"] for when in ("calm", "stream"))
    assert watched["50.0"] <= 1.1 * calm["50.0"], result
