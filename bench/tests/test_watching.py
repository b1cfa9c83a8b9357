"""Checks that watching a fleet can be measured (short), and the goal (soak)."""

import pytest

from dronemap_bench.watching import GOAL_PERCENT, Options, measure, summary, table


def test_watching_is_measured() -> None:
    options = Options(rounds=1, drones=3, seconds=2.0)
    figures = summary(measure(options))
    assert all(each["states"]["median"] > 3 for each in figures.values()), figures
    assert all(0 < each["percent"]["median"] < 100 for each in figures.values()), figures
    assert "| the client |" in table(figures, options, 1.0)


@pytest.mark.soak
def test_watching_two_hundred_drones_meets_its_goal() -> None:
    figures = summary(measure(Options()))
    assert figures["the client"]["percent"]["median"] <= GOAL_PERCENT, figures
