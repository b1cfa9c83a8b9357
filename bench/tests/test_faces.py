"""Checks that calls and viewers can be measured (short), the summary, and the goals (soak)."""

import pytest

from dronemap_bench.faces import report, trial
from dronemap_bench.faces.calls import percentile, time_interleaved
from dronemap_bench.programs import SERVER_JAR, Json

SMALL = trial.Options(
    rounds=1,
    vehicles=3,
    warm_up_calls=2,
    calls=3,
    lists=3,
    commands=3,
    viewers=4,
    watched=2,
    warm_up_seconds=6,
    seconds=3,
)


def test_calls_and_viewers_are_measured() -> None:
    result = trial.measure(SMALL, SERVER_JAR)
    summary = report.summary({report.NOW: [result]})
    assert all(figure[report.NOW]["median"] > 0 for name, figure in summary.items() if "more" not in name), (
        summary
    )
    assert result["stream"]["fewest"] > 0
    assert result["stream"]["shareOfPositions"] > 0.5


@pytest.mark.soak
def test_call_latency_beside_a_thousand_vehicles_meets_goals() -> None:
    rounds = [trial.measure(trial.Options(), SERVER_JAR) for _ in range(3)]
    assert report.missed(report.summary({report.NOW: rounds})) == []


def test_call_kinds_alternate() -> None:
    made: list[str] = []
    took = time_interleaved(2, lambda: made.append("a"), lambda: made.append("b"))
    assert made == ["a", "b", "a", "b"]
    assert [len(times) for times in took] == [2, 2]


def test_percentile_is_one_of_the_values() -> None:
    values = [float(value) for value in range(100, 0, -1)]
    assert percentile(values, 0.5) == 51
    assert percentile(values, 0.95) == 96
    assert percentile([7.0], 0.99) == 7


def figures(milliseconds: float) -> Json:
    spread = {"p50": milliseconds, "p95": milliseconds, "p99": milliseconds}
    names = ("oneByRest", "oneBySoap", "listByRest", "listBySoap", "commandByRest", "commandBySoap")
    stream = {"ageMillis": spread, "shareOfPositions": 1, "cpuMicrosPerMessage": 1, "residentMegabytes": 1}
    return {"calls": {name: spread for name in names} | {"soapMoreAtP50": milliseconds}, "stream": stream}


def test_median_of_rounds_is_compared_with_goals() -> None:
    summary = report.summary({report.NOW: [figures(1), figures(1.5), figures(99)]})
    assert summary["REST, list of all, p95 ms"][report.NOW] == {"median": 1.5, "least": 1, "most": 99}
    assert report.missed(summary) == []
    missed = report.missed(report.summary({report.NOW: [figures(10)]}))
    assert missed == [
        "command by REST, p95 ms: 10 instead of less than 10.0",
        "SOAP more than REST, p50 ms: 10 instead of less than 2.0",
    ]


def test_table_has_a_column_for_each_version() -> None:
    summary = report.summary({report.NOW: [figures(1)], report.BEFORE: [figures(2)]})
    text = report.table(summary, {"processor": "p", "java": "j", "revision": "r"}, 0.1)
    assert "| command by REST, p95 ms | 1 (1 to 1) | 2 (2 to 2) |" in text
