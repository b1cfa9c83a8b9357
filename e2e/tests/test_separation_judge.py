"""The judge of separation finds breaches, waypoints left out and who is late, in tracks made by hand."""

import json
import math
from pathlib import Path
from typing import Any

import pytest

from dronemap_e2e.separation_judge import (
    COLUMNS,
    FlightRefused,
    Limits,
    State,
    Tracks,
    Verdict,
    judge,
    main,
    metres_apart,
    read_tracks,
)

LIMITS = Limits()
PAD_AMSL = 488.0
# On the equator, by WGS84.
METRES_PER_DEGREE_EAST = math.radians(6_378_137.0)


def place(east: float, up: float, *, step: int = 0, armed: bool = True) -> State:
    return State(step, 0.0, east / METRES_PER_DEGREE_EAST, PAD_AMSL + up, up, armed)


def standing(east: float, up: float, *, steps: int = 20) -> list[State]:
    """In the air at one place, and down at the end."""
    flown = [place(east, up, step=step) for step in range(steps)]
    return [*flown, place(east, 0, step=steps, armed=False)]


def operation(vehicles: list[str], **other: Any) -> dict[str, Any]:
    usual = {"name": "run", "vehicles": vehicles, "begins": 0.0, "undisturbed": 2.0}
    return {**usual, "required": True, "waypoints": [], **other}


def judged(tracks: Tracks, *operations: dict[str, Any]) -> Verdict:
    wanted = list(operations) or [operation(list(tracks))]
    return judge(tracks, {"scenario": "made", "seed": 1, "mechanism": True, "operations": wanted}, LIMITS)


def test_breach_at_one_step_is_found() -> None:
    """Of the judge alone: it starts nothing."""
    passing = standing(30, 20)
    passing[7] = place(9.9, 24.9, step=7)
    verdict = judged({"a": standing(0, 20), "b": passing, "c": standing(300, 20)})
    assert verdict.result == "breach"
    (breach,) = verdict.breaches
    assert (breach.second, breach.pair) == (0.7, ("a", "b"))
    assert (round(breach.horizontal, 2), round(breach.vertical, 2)) == (9.9, 4.9)
    assert "breach, a and b at 0.7 s: 9.9 m beside, 4.9 m above each other" in verdict.words


def test_first_breach_of_each_pair_and_nearest_of_all() -> None:
    """Of the judge alone: it starts nothing."""
    nearer = [place(9 - step / 10, 20, step=step) for step in range(20)] + [place(7, 0, step=20, armed=False)]
    verdict = judged({"a": standing(0, 20), "b": nearer})
    assert [one.second for one in verdict.breaches] == [0.0]
    assert (verdict.nearest.second, round(verdict.nearest.horizontal, 2)) == (1.9, 7.1)
    assert verdict.row()[5:10] == ["0.0", "a and b", "7.10", "0.00", "0.710"]


@pytest.mark.parametrize(("east", "up"), [(10.0, 20.0), (0.0, 25.0), (10.0, 25.0), (9.0, 25.0), (10.0, 21.0)])
def test_touching_a_limit_is_no_breach(east: float, up: float) -> None:
    """Of the judge alone: it starts nothing."""
    assert judged({"a": standing(0, 20), "b": standing(east, up)}).result == "ok"


def test_who_takes_off_or_lands_is_not_counted() -> None:
    """Of the judge alone: it starts nothing."""
    assert judged({"a": standing(0, 2.0), "b": standing(1, 3)}).result == "ok"
    assert judged({"a": standing(0, 2.1), "b": standing(1, 3)}).result == "breach"


def test_heights_are_those_above_the_sea() -> None:
    """Of the judge alone: pads of different heights, and vehicles as high above them as each other."""
    hill = [State(one.step, 0.0, 0.0, one.amsl + 6, one.above_pad, one.armed) for one in standing(0, 20)]
    assert judged({"a": standing(0, 20), "b": hill}).result == "ok"


def test_different_times_are_no_breach() -> None:
    """Of the judge alone: it starts nothing."""
    later = [State(one.step + 100, *_rest(one)) for one in standing(0, 20)]
    assert judged({"a": standing(0, 20), "b": later}, operation(["a"])).result == "ok"


def _rest(one: State) -> tuple[float, float, float, float, bool]:
    return one.latitude, one.longitude, one.amsl, one.above_pad, one.armed


def test_waypoint_has_to_be_passed_within_two_metres() -> None:
    """Of the judge alone: height counts."""

    def waypoint(east: float, up: float) -> dict[str, Any]:
        degrees = east / METRES_PER_DEGREE_EAST
        return {"name": "1", "latitude": 0.0, "longitude": degrees, "amsl": PAD_AMSL + up}

    flown = {"a": standing(0, 20)}
    served = operation(["a"], waypoints=[waypoint(1.9, 20)])
    beyond = operation(["a"], waypoints=[waypoint(1.9, 21)])
    assert judged(flown, served).result == "ok"
    assert judged(flown, beyond).unserved == ["run waypoint 1 by 2.1 m"]
    assert judged(flown, {**beyond, "required": False}).result == "ok"


def test_who_is_down_too_late_or_not_at_all_is_found() -> None:
    """Of the judge alone: half as long again as undisturbed, and 30 s, for everybody together."""
    assert judged({"a": standing(0, 20, steps=329)}).result == "ok"
    late = judged({"a": standing(0, 20, steps=331)})
    assert late.late == ["everybody down after 33.1 s instead of 2.0 s undisturbed"]
    assert round(late.factor, 2) == 16.55
    assert judged({"a": standing(0, 20, steps=331)}, operation(["a"], begins=1.0)).result == "ok"
    assert judged({"a": standing(0, 20, steps=331)}, operation(["a"], undisturbed=None)).result == "ok"
    both = {"a": standing(0, 20, steps=331), "b": standing(300, 20)}
    later = operation(["b"], begins=0.5)
    together = judged(both, operation(["a"]), later)
    assert (together.result, round(together.factor, 2)) == ("ok", 13.24)
    up = judged({"a": standing(0, 20)[:-1]}, operation(["a"], undisturbed=None))
    assert up.late == ["run: a still up at the end"]
    assert math.isinf(up.factor)
    armed = [*standing(0, 20), place(0, 0, step=21)]
    assert judged({"a": armed}).result == "late"


def test_metres_are_those_of_the_earth() -> None:
    """Of the judge alone: against lengths of a degree from tables of WGS84."""
    assert abs(metres_apart(44.5, 8.0, 45.5, 8.0) - 111_131.8) < 2
    assert abs(metres_apart(45.0, 8.0, 45.0, 9.0) - 78_846.8) < 2


def test_gaps_and_other_seeds_are_refused() -> None:
    """Of the judge alone: what is not there cannot have been apart."""
    head = ",".join(COLUMNS)
    rows = ["1,0.0,a,0,0,508,20,1", "1,0.2,a,0,0,508,20,1"]
    with pytest.raises(FlightRefused, match=r"a has no state 0.1 s before 0.2 s"):
        read_tracks([head, *rows], 1)
    with pytest.raises(FlightRefused, match="seed 1"):
        read_tracks([head, *rows], 2)
    with pytest.raises(FlightRefused, match="columns"):
        read_tracks(["second,vehicle", "1,a"], 1)


def written(folder: Path, seed: int, tracks: Tracks) -> str:
    folder.mkdir(parents=True)
    facts = {
        "scenario": "made",
        "seed": seed,
        "mechanism": False,
        "operations": [operation(list(tracks))],
    }
    (folder / "facts.json").write_text(json.dumps(facts))
    rows = [
        f"{seed},{one.second:.1f},{name},{one.latitude:.9f},{one.longitude:.9f},{one.amsl:.3f},"
        f"{one.above_pad:.3f},{int(one.armed)}"
        for name, track in tracks.items()
        for one in track
    ]
    (folder / "tracks.csv").write_text("\n".join([",".join(COLUMNS), *rows]) + "\n")
    return str(folder)


def test_folders_are_judged_and_kept_in_a_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Of the judge alone: as a program; touching stays a touch through the file."""
    table = tmp_path / "table.tsv"
    near = written(tmp_path / "near", 10, {"a": standing(0, 20), "b": standing(4, 21)})
    touch = written(tmp_path / "touch", 9, {"a": standing(0, 20), "b": standing(10, 20)})
    assert main([near, touch, "--table", str(table)]) == 1
    assert "2 flights, 1 with a breach" in capsys.readouterr().out
    assert main([near, touch, "--table", str(table), "--breaching", "0.5"]) == 0
    assert main([near, touch, "--breaching", "0.8"]) == 1
    assert main([touch, "--table", str(table)]) == 0
    lines = [line.split("\t")[:7] for line in table.read_text().splitlines()[1:]]
    assert lines == [
        ["made", "9", "", "off", "ok", "0.0", "a and b"],
        ["made", "10", "", "off", "breach", "0.0", "a and b"],
    ]
    (tmp_path / "near" / "facts.json").unlink()
    assert main([near]) == 2
