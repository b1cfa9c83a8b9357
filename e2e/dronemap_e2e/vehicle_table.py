"""The table of docs/vehicles.md: what the trial of real autopilots has proved of which vehicle.

Usage: python -m dronemap_e2e.vehicle_table
"""

from pathlib import Path

from .server import ROOT

PROVED = ROOT / "docs" / "trials" / "sitl-proved.tsv"
PAGE = ROOT / "docs" / "vehicles.md"
BEGIN = "<!-- written by the trial of real autopilots: begin -->"
END = "<!-- written by the trial of real autopilots: end -->"
VEHICLES = ("Copter", "QuadPlane", "Plane", "Rover")
COLUMNS = ("vehicle", "firmware", "job", "how")
# In the order of the table.
JOBS = (
    "Listed with its name, mode, place and battery",
    "Arm, disarm",
    "Change the mode",
    "Take off",
    "Go to a place",
    "Hold",
    "Turn on the spot",
    "Change speed",
    "Land",
    "Return home",
    "Mission sent, read back the same, cleared",
    "Mission: take off",
    "Mission: waypoint that holds",
    "Mission: wait, photo, servo",
    "Mission: look at a place, look ahead",
    "Mission: land",
    "Mission: return home",
    "Mission paused and continued",
    "Fence on board",
    "Rally points",
    "Parameters",
    "Flight logs",
    "Home moved",
    "Picture, relay",
    "Mission run with other vehicles",
)


def read(file: Path) -> list[tuple[str, ...]]:
    """Vehicle, firmware, job and how, without the head."""
    return [tuple(line.split("\t")) for line in file.read_text(encoding="utf-8").splitlines()[1:]]


def table(lines: list[tuple[str, ...]]) -> str:
    """A row for each job, a column for each vehicle."""
    how = {(vehicle, job): words for vehicle, _, job, words in lines}
    firmware = {vehicle: version for vehicle, version, _, _ in lines}
    heads = [f"{one} ({firmware[one]})" if one in firmware else one for one in VEHICLES]
    rows = [
        " | ".join([job, *(how.get((vehicle, job), "not proved") for vehicle in VEHICLES)]) for job in JOBS
    ]
    return "\n".join(f"| {row} |" for row in [" | ".join(["", *heads]), " | ".join(["---"] * 5), *rows])


def page(text: str, lines: list[tuple[str, ...]]) -> str:
    """The page with the table in its place."""
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    assert rest and after, f"{PAGE} has no place for the table"
    return f"{before}{BEGIN}\n{table(lines)}\n{END}{after}"


def write() -> None:
    PAGE.write_text(page(PAGE.read_text(encoding="utf-8"), read(PROVED)), encoding="utf-8")


if __name__ == "__main__":
    write()
