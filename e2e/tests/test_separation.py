"""The judge of separation finds the nearest two vehicles, and when they were."""

from dronemap_e2e.separation import METRES_PER_DEGREE, Fix, nearest

SECONDS = range(0, 20)


def track(east: float, amsl: float, height: float = 20.0) -> list[Fix]:
    """On the equator, where a degree is as long east as north."""
    return [Fix(float(second), 0.0, east / METRES_PER_DEGREE, amsl, height) for second in SECONDS]


def test_nearest_pair_is_found() -> None:
    """Of the judge alone: what was recorded is made here."""
    found = nearest({1: track(0, 500), 2: track(30, 500), 3: track(27, 501)}, 0, 20)
    assert abs(found.share - 0.3) < 0.01
    assert found.words == "2 and 3: 3.0 m beside, 1.0 m above each other"


def test_height_and_distance_count_as_separation() -> None:
    """Of the judge alone: what was recorded is made here."""
    assert abs(nearest({1: track(0, 500), 2: track(1, 505)}, 0, 20).share - 1) < 0.01


def test_vehicles_on_the_ground_and_other_times_are_left_out() -> None:
    """Of the judge alone: what was recorded is made here."""
    assert nearest({1: track(0, 500), 2: track(1, 500, height=0)}, 0, 20).share > 1000
    late = [Fix(second + 100.0, 0.0, 0.0, 500.0, 20.0) for second in SECONDS]
    early = [Fix(second.at, 0.0, 0.0, 500.0, 0.0 if second.at >= 19 else 20.0) for second in track(0, 500)]
    assert nearest({1: early, 2: late}, 100, 120).share > 1000
