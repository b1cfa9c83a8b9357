"""Checks that what the PHP SOAP proxy adds can be measured (short), and the goal (soak)."""

import pytest

from dronemap_bench.php import Options, measure, missed, summary, table


def test_php_proxy_is_measured() -> None:
    options = Options(rounds=1, calls=20, drones=2)
    figures = summary(measure(options))
    assert all(ways["soap"]["p50"]["median"] > 0 for ways in figures.values()), figures
    assert all(ways["proxy"]["p50"]["median"] > 0 for ways in figures.values()), figures
    assert "| one drone |" in table(figures, options, 1.0)


def test_missed_goal_is_told() -> None:
    late = {"added": {"p95": {"median": 5.1}}}
    assert missed({"one drone": late})
    late["added"]["p95"]["median"] = 4.9
    assert not missed({"one drone": late})


@pytest.mark.soak
def test_php_proxy_meets_its_goal() -> None:
    assert not missed(summary(measure(Options())))
