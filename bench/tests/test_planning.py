"""Wrong tours are seen, moved instances are the same ones, and that tables tell what was measured."""

import json
import math
from pathlib import Path

import pytest

from dronemap_bench.planning import __main__ as command
from dronemap_bench.planning import checker, flown, losses, modes, plot, problems, report, runs, study
from dronemap_bench.planning.problems import Moved, Problem, Row

SQUARE = Problem("euclidean", "longest", ((0.0, 0.0), (10.0, 0.0)), ((0.0, 5.0), (10.0, 5.0), (10.0, 9.0)))


def result(solver: str, gap: float, seed: int = 1, instance: str = "square") -> runs.Result:
    plan = runs.SolverRun(solver, seed, 1.0, 1, 0.0, False)
    points = [(0.1, gap + 5), (0.5, gap)]
    return runs.Result(instance, "longest", plan, "", 18, gap, 1.01, 1.1, 3.0, points, [[0], [1, 2]])


def test_tour_length_includes_depot_legs() -> None:
    assert checker.value(SQUARE, [[0], [1, 2]]) == 18
    assert checker.value(Problem("euclidean", "sum", *(SQUARE.depots, SQUARE.waypoints)), [[0], [1, 2]]) == 28
    assert checker.faults(SQUARE, [[0], [1, 2]]) == []


def test_att_distances_are_rounded_up() -> None:
    assert checker.value(Problem("att", "longest", ((0.0, 0.0),), ((30.0, 40.0),)), [[0]]) == 32


@pytest.mark.parametrize(
    ("tours", "fault"),
    [
        ([[0], [1]], "waypoint 2 is visited 0 times"),
        ([[0, 2], [1, 2]], "waypoint 2 is visited 2 times"),
        ([[0, 3], [1, 2]], "there is no waypoint 3"),
        ([[0, 1, 2]], "1 tours for 2 drones"),
    ],
)
def test_wrong_tours_are_reported(tours: list[list[int]], fault: str) -> None:
    assert fault in checker.faults(SQUARE, tours)


def test_sum_objective_needs_every_drone() -> None:
    idle = [[0, 1, 2], []]
    assert checker.faults(SQUARE, idle) == []
    whole = Problem("euclidean", "sum", SQUARE.depots, SQUARE.waypoints)
    assert checker.faults(whole, idle) == ["drone 1 stays idle"]


def _scale(shifted: Moved) -> float:
    return math.dist(*shifted.problem.depots) / math.dist(*SQUARE.depots)


def test_moved_instance_has_same_value_and_other_coordinates() -> None:
    for seed in range(1, 20):
        shifted = problems.moved(SQUARE, seed)
        tours = [[2], [0, 1]]
        back = shifted.back(tours)
        assert checker.value(shifted.problem, tours) == pytest.approx(
            _scale(shifted) * checker.value(SQUARE, back)
        )
        assert not set(shifted.problem.waypoints) & set(SQUARE.waypoints)
        assert problems.moved(SQUARE, seed) == shifted


def test_moving_keeps_rounded_distances() -> None:
    att = Problem("att", "longest", SQUARE.depots, SQUARE.waypoints)
    for seed in range(1, 20):
        shifted = problems.moved(att, seed)
        assert checker.value(shifted.problem, [[2], [0, 1]]) == checker.value(
            att, shifted.back([[2], [0, 1]])
        )


def data(folder: Path) -> Path:
    (folder / "coords").mkdir()
    (folder / "coords" / "a.json").write_text(
        json.dumps({"depots": [{"x": 0, "y": 0}], "waypoints": [[1, 0], [2, 0]]})
    )
    depots = [{"x": 0, "y": 0, "drones": 1}, {"x": 9, "y": 0, "drones": 2}]
    (folder / "coords" / "b.json").write_text(json.dumps({"depots": depots, "waypoints": [[1, 0]] * 3}))
    (folder / "index.csv").write_text(
        "instance,file,n_waypoints,m_drones,depots,objective,best_known,edge_weight,source\n"
        "a_m2,coords/a.json,2,2,1,min-max,4,EUC_2D_REAL,a paper\n"
        "b,coords/b.json,3,3,2,min-sum,7.5,EUC_2D_REAL,best found in a long run\n"
    )
    return folder


def test_instances_are_read_with_a_depot_for_each_drone(tmp_path: Path) -> None:
    one, several = problems.read(data(tmp_path))
    assert one == Row("a_m2", 4, True, Problem("euclidean", "longest", ((0, 0), (0, 0)), ((1, 0), (2, 0))))
    assert several.problem.depots == ((0, 0), (9, 0), (9, 0))
    assert (several.published, several.problem.aim) == (False, "sum")


def test_solver_input_has_no_instance_name(tmp_path: Path) -> None:
    one, _ = problems.read(data(tmp_path))
    assert one.problem.text().splitlines() == [
        "metric euclidean",
        "aim longest",
        "depot 0.0 0.0",
        "depot 0.0 0.0",
        "waypoint 1.0 0.0",
        "waypoint 2.0 0.0",
    ]


def test_solver_answer_is_parsed() -> None:
    lines = ["about x y", "improved 0.5 12.25", "used 1.01", "tour 0 2", "tour ", "tour 1"]
    assert runs.parse(lines) == runs.SolverOutput("x y", [(0.5, 12.25)], 1.01, [[0, 2], [], [1]])


def stub_solver(monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    monkeypatch.setattr(runs, "_java", lambda file, plan: text)


def test_result_is_checked_before_it_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    row, plan = Row("square", 16.0, True, SQUARE), runs.SolverRun("x", 1, 1.0, 1, 0.0, False)
    stub_solver(monkeypatch, "improved 0.5 18\nused 1\ntour 0\ntour 1 2\n")
    measured = runs.run(row, plan)
    assert (measured.value, measured.gap_percent, measured.points) == (18, 12.5, [(0.5, 12.5)])
    stub_solver(monkeypatch, "improved 0.5 18\nused 1\ntour 0\ntour 1\n")
    with pytest.raises(runs.RunError, match="waypoint 2 is visited 0 times"):
        runs.run(row, plan)
    stub_solver(monkeypatch, "improved 0.5 17\nused 1\ntour 0\ntour 1 2\n")
    with pytest.raises(runs.RunError, match="says 17"):
        runs.run(row, plan)
    stub_solver(monkeypatch, "used 1\ntour 0\ntour 1 2\n")
    with pytest.raises(runs.RunError, match="tells of no plan"):
        runs.run(row, plan)


def test_tours_of_moved_instance_are_mapped_back(monkeypatch: pytest.MonkeyPatch) -> None:
    shifted = problems.moved(SQUARE, 5)
    value = checker.value(shifted.problem, [[0], [1, 2]])
    stub_solver(monkeypatch, f"improved 0.5 {value}\nused 1\ntour 0\ntour 1 2\n")
    measured = runs.run(Row("square", 16.0, True, SQUARE), runs.SolverRun("x", 5, 1.0, 1, 0.0, True))
    assert measured.tours == shifted.back([[0], [1, 2]])
    assert measured.value == pytest.approx(value / _scale(shifted))


ABOUT = {"at": "now", "processor": "a computer", "java": "17", "revision": "abc"}


def test_table_shows_medians_and_best_solver() -> None:
    results = [result("dronemap", gap, seed) for seed, gap in enumerate((0.5, 0.2, 9.0), 1)]
    results += [result("other", gap, seed) for seed, gap in enumerate((0.45, 0.45, 0.4), 1)]
    results += [result("dronemap", 2, instance="ring"), result("other", 1, instance="ring")]
    text = report.table(ABOUT, results)
    assert "| square | longest | 0.50 | 0.45 |" in text
    assert "| **mean** | longest | 1.25 | 0.72 |" in text
    assert "| **max** | longest | 2.00 | 1.00 |" in text
    assert "against `other` at 1 s: better or tied on 1 of 2" in text
    assert "Better than the best known" not in text
    assert "Better than the best known value: ring." in report.table(
        ABOUT, [result("dronemap", -0.5, instance="ring")]
    )


def test_plot_shows_median_run() -> None:
    several = [result("dronemap", gap, seed) for seed, gap in enumerate((3.0, 1.0, 2.0), 1)]
    chosen = plot.typical(several)
    assert chosen is not None
    assert chosen.gap_percent == 2
    picture = plot.convergence([*several, result("other", 7)])
    assert picture.count("<polyline") == 2
    assert "square (longest)" in picture


def test_modes_select_their_instances() -> None:
    row = Row("mtsp51_m3", 1, True, SQUARE)
    ours = Row("own", 1, False, SQUARE)
    selects = {mode.name for mode in modes.MODES if mode.selects(row)}
    assert selects == {"minmax-1s", "minmax-10s", "libraries", "moved", "baselines", "depots-60s"}
    assert not modes.named("minmax-1s").selects(ours)


def test_written_results_are_checked_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rows = [Row("square", 16, True, SQUARE)]
    report.write(tmp_path, "good", ABOUT, [result("x", 1)])
    command.check(tmp_path / "good.json", rows)
    assert "1 results, 0 wrong" in capsys.readouterr().out
    results = json.loads((tmp_path / "good.json").read_text())
    results["results"][0]["tours"] = [[0, 1], [2]]
    (tmp_path / "bad.json").write_text(json.dumps(results))
    with pytest.raises(SystemExit):
        command.check(tmp_path / "bad.json", rows)
    assert "says 18" in capsys.readouterr().out


def test_missing_instances_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DRONEMAP_TEST_DATA", raising=False)
    with pytest.raises(SystemExit, match="--data FOLDER"):
        command.main(["minmax-1s"])


def test_replan_output_is_parsed_and_tabulated() -> None:
    cases = losses.parse(
        ["noise", "case 2.0 90.0 0 120.0 101.0 100.0 3", "case 4.0 95.5 1 130.0 99.0 100.0 9"]
    )
    assert [case.gap_percent for case in cases] == [pytest.approx(1.0), 0.0]
    table = losses.table(losses.Setup(2, 200, 10, 100, 10), cases)
    assert "200 waypoints and 10 drones lose one; 1 faults" in table
    assert "| a plan at once, ms | 3.00 | 3.00 | 4.00 | 4.00 |" in table


def test_replan_percentile_is_a_measured_value() -> None:
    assert losses.percentile([float(value) for value in range(1, 201)], 95) == 190
    assert losses.percentile([3.0], 95) == 3


STUDIED = [
    "run 2 4 1 40 39 3 true 200.00 300.00 12.00 [3.25,10.75]",
    "run 1 5 0 40 40 0 true 200.00 200.00 1000.00 []",
    "broken 3 two drones fly to w7",
    "",
]


def test_study_counts_unserved_waypoints_and_names_broken_rules() -> None:
    done = study.parse(iter(STUDIED))
    assert [run.seed for run in done.runs] == [1, 2]
    text = study.table(done)
    assert (
        "79 of 80 waypoints visited; 1 missions did not visit all, 1 of them though a drone was left" in text
    )
    assert "| 1.25 | 1.25 | 1.50 | 1.00 | 1.50 |" in text
    assert "| 7.00 | 7.00 | 10.75 | 3.25 | 10.75 |" in text
    assert "- seed 3 two drones fly to w7" in text


def test_study_plots_cumulative_shares() -> None:
    picture = study.picture(study.parse(iter(STUDIED)))
    assert picture.count("<polyline") == 4
    assert "1 lost: 1" in picture and "none lost: 1" in picture


FLOWN = [
    "about Performance[…]",
    "flown 2 measured 4.50 3 9 200.00 208.00 40000 41000",
    "flown 1 measured 0.00 0 4 100.00 97.00 20000 19000",
    "flown 1 assumed 0.00 0 4 120.00 97.00 50000 19000",
]


def test_flown_plans_are_compared_with_forecast() -> None:
    flights = flown.parse(FLOWN)
    assert [(flight.figures, flight.seed) for flight in flights] == [
        ("assumed", 1),
        ("measured", 1),
        ("measured", 2),
    ]
    text = flown.table(flights)
    assert "| time, figures measured of that copter | 2 | +0.50 | 4.00 | 4.00 |" in text
    assert "| energy, figures as its autopilot is delivered | 1 | -62.00 | 62.00 | 62.00 |" in text
    assert flown.meets_forecast(flights)
    late = flown.parse(["flown 3 measured 1.00 0 4 100.00 105.10 1000 1000"])
    thirsty = flown.parse(["flown 3 measured 1.00 0 4 100.00 100.00 1000 1110"])
    assert not flown.meets_forecast(late) and not flown.meets_forecast(thirsty)
