"""The page of what works with which vehicle says what the trial of real autopilots saw, and no more."""

from dronemap_e2e import vehicle_table

LINE = ("Copter", "ArduCopter 4.5.6", "Take off", "yes")


def test_page_says_what_was_proved() -> None:
    """Of the judge alone: the table of the page is the one that its lines give."""
    text = vehicle_table.PAGE.read_text(encoding="utf-8")
    assert vehicle_table.page(text, vehicle_table.read(vehicle_table.PROVED)) == text


def test_what_nobody_flew_is_not_proved() -> None:
    """Of the judge alone: only what has a line is said to work."""
    rows = [row.split(" | ") for row in vehicle_table.table([LINE]).splitlines()]
    assert rows[0] == ["| ", "Copter (ArduCopter 4.5.6)", "QuadPlane", "Plane", "Rover |"] or rows[0][1] == (
        "Copter (ArduCopter 4.5.6)"
    )
    cells = {row[0].removeprefix("| "): row[1:] for row in rows[2:]}
    assert cells["Take off"] == ["yes", "not proved", "not proved", "not proved |"]
    assert set(cells) == set(vehicle_table.JOBS)
    assert sum(cell.startswith("not proved") for row in cells.values() for cell in row) == len(cells) * 4 - 1
