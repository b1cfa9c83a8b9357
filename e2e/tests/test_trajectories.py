"""The judge of flown trajectories finds visits, crossings and near pairs."""

from dronemap_e2e.trajectories import Disc, Fix, Spot, Track, crossings, doubles, nearest, visits

SPOTS = [Spot("1", 50, 0, 20), Spot("2", 100, 0, 20)]


def flown(*legs: tuple[float, float, float], speed: float = 5.0, stands: float = 3.0) -> Track:
    """From place to place (east, north, up), four reports a second, standing for a while at each."""
    fixes: list[Fix] = []
    seconds = 0.0
    for start, end in zip(legs, legs[1:], strict=False):
        length = sum((b - a) ** 2 for a, b in zip(start, end, strict=True)) ** 0.5
        steps = max(1, round(length / speed * 4))
        for step in range(1, steps + 1):
            at = [a + (b - a) * step / steps for a, b in zip(start, end, strict=True)]
            seconds += 0.25
            fixes.append(Fix(seconds, at[0], at[1], at[2], at[2]))
        for _ in range(round(stands * 4)):
            seconds += 0.25
            fixes.append(Fix(seconds, *end, end[2]))
    return Track(fixes)


def test_visit_needs_slow_passage_and_is_counted_each_time() -> None:
    """Of the judge alone: it starts nothing."""
    stops_at_both = flown((0, 0, 20), (50, 0, 20), (100, 0, 20), (50, 0, 20))
    passes = flown((0, 1, 20), (150, 1, 20))
    too_low = flown((0, 0, 14), (50, 0, 14))
    found = visits({1: stops_at_both, 2: passes, 3: too_low}, SPOTS)
    assert [(visit.waypoint, visit.vehicle) for visit in found] == [("1", 1), ("2", 1), ("1", 1)]
    assert list(doubles(found)) == ["1"]


def test_visit_at_take_off_is_marked() -> None:
    """Of the judge alone: it starts nothing."""
    beside = Spot("3", 2, 0, 20)
    found = visits({1: flown((0, 0, 0), (0, 0, 20), (50, 0, 20), (2, 0, 20))}, [*SPOTS, beside])
    assert [(visit.waypoint, visit.at_start) for visit in found] == [("3", True), ("1", False), ("3", False)]


def test_fence_crossing_below_top_and_between_reports() -> None:
    """Of the judge alone: it starts nothing."""
    discs = [Disc("mill", 50, 0, 1, 30)]
    assert crossings({1: flown((0, 0, 20), (100, 0, 20), speed=40)}, discs)[0][:2] == (1, "mill")
    assert not crossings({1: flown((0, 0, 31), (100, 0, 31))}, discs)
    assert not crossings({1: flown((0, 2, 20), (100, 2, 20))}, discs)


def test_nearest_pair_counts_distance_and_height() -> None:
    """Of the judge alone: it starts nothing."""
    along = flown((0, 0, 20), (100, 0, 20))
    least = nearest({1: along, 2: flown((100, 4, 22), (0, 4, 22))})
    assert least is not None and abs(least.metres - 4) < 0.6 and abs(least.height - 2) < 0.1
    assert nearest({1: along, 2: flown((100, 4, 26), (0, 4, 26))}) is None
    assert nearest({1: Track(along.fixes, ends=2.0), 2: flown((100, 4, 22), (60, 4, 22))}).metres > 30  # type: ignore[union-attr]
