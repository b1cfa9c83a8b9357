"""dronectl plan: waypoints shared out among drones."""

import asyncio
from pathlib import Path
from typing import Any

import click
from rich.table import Table

from dronectl.command import DRONE, Group, agreed, connected, yes_option
from dronectl.failure import NotDone
from dronectl.output import table
from dronectl.reading import FILE, fitted, json_of
from dronectl.run import watched
from dronectl.settings import Session, chosen
from dronemap.contract.models import PlanAcceptRequest, PlanRequest, PlanView, RunStartRequest
from dronemap.plan import AsyncPlan

_OBJECTIVES = ("earliestEnd", "leastTime", "leastDistance", "leastEnergy")
_FAILED = ("heldBack", "failed")
#: The stages of an accepted plan are not on the stream alone; nobody reads them faster.
_LOOK_SECONDS = 1.0
_CLOUD_LOSS = click.option(
    "--on-cloud-loss",
    type=click.Choice(["continue", "rtl"]),
    help="What the drones do when they hear the server no more.",
)


@click.group(cls=Group)
def plan() -> None:
    """Share waypoints out among drones, and fly that."""


@plan.command()
@click.argument("file", type=FILE)
@click.option("-d", "--drone", "drones", type=DRONE, multiple=True, help="Name or id; instead of those in FILE.")
@click.option(
    "--up-to", type=click.IntRange(1, 100), help="Up to so many drones of the pool, which the server chooses."
)
@click.option("--seconds", type=float, help="How long to search, 0.1 to 60.")
@click.option("--objective", type=click.Choice(_OBJECTIVES), help="What the plan is to be good at.")
@connected
async def make(
    session: Session,
    file: Path,
    drones: tuple[str, ...],
    up_to: int | None,
    seconds: float | None,
    objective: str | None,
) -> None:
    """Make a plan for the waypoints in FILE, and show it.

    FILE is JSON: a list of waypoints, or an object with "waypoints" and whatever else a plan is asked for with. The
    search goes on at the server, with Ctrl-C as well; delete ends it.
    """
    given = json_of(file)
    asked = {"waypoints": given} if isinstance(given, list) else given
    if not isinstance(asked, dict):
        raise click.UsageError(f"{file} must be a list of waypoints or an object.", click.get_current_context())
    asked = asked | await _drones(session, asked, drones, up_to)
    if seconds is not None:
        asked["seconds"] = seconds
    if objective is not None:
        asked["objective"] = {"kind": objective}
    made = await session.server.plan(fitted(file, asked, PlanRequest))
    with session.output.working(f"Plan {made.id}") as working:
        async for view in made.progress():
            best = view.progress
            if best is not None:
                words = f"Plan {view.id}: {best.longest_seconds:.0f} s long, {best.unserved} left out"
                working.say(words, min(best.seconds, view.seconds), view.seconds)
    _show(session, await made.wait())


async def _drones(
    session: Session, asked: dict[str, Any], drones: tuple[str, ...], up_to: int | None
) -> dict[str, Any]:
    """The drones by their ids, or how many of the pool: what is said here goes before what the file says."""
    if drones and up_to is not None:
        raise click.UsageError("Say either --drone or --up-to.", click.get_current_context())
    names = list(drones) or ([] if up_to is not None else asked.get("drones") or [])
    most = up_to if up_to is not None or names else asked.get("upTo")
    if most is not None:
        return {"drones": None, "upTo": most}
    if not names:
        raise click.UsageError("Say which drones with --drone, or how many with --up-to.", click.get_current_context())
    known = (await session.server.rest.list_drones()).drones
    return {"drones": [chosen(known, str(name)).id for name in names], "upTo": None}


@plan.command()
@click.argument("id")
@connected
async def show(session: Session, id: str) -> None:
    """Show who flies where."""
    _show(session, await session.server.rest.get_plan(id))


@plan.command("list")
@connected
async def list_plans(session: Session) -> None:
    """List the plans."""
    answer = await session.server.rest.list_plans()
    rows = [
        (view.id, view.state, view.waypoints, ", ".join(drone.name for drone in view.drones), view.by, view.asked_at)
        for view in answer.plans
    ]
    session.output.show(answer, table(("ID", "STATE", "WAYPOINTS", "DRONES", "BY", "ASKED"), rows))


@plan.command()
@click.argument("id")
@click.option("--start", is_flag=True, help="Arm and start the drones as well: they fly.")
@_CLOUD_LOSS
@click.option("--no-wait", is_flag=True, help="End while the missions are still under way.")
@connected
async def accept(session: Session, id: str, start: bool, on_cloud_loss: str | None, no_wait: bool) -> None:
    """Bring each drone its mission of the plan.

    Ctrl-C ends the waiting only; dronectl call stopPlan id=ID keeps those on the ground that have not started yet.
    """
    asked = PlanAcceptRequest.model_validate({"start": start, "on_cloud_loss": on_cloud_loss})
    view = await session.server.rest.accept_plan(id, asked)
    with session.output.working(f"Plan {id}") as working:
        while not no_wait and view.launch is not None and view.launch.under_way:
            working.say(", ".join(f"{flight.name} {flight.stage}" for flight in view.launch.drones))
            await asyncio.sleep(_LOOK_SECONDS)
            view = await session.server.rest.get_plan(id)
    flights = view.launch.drones if view.launch else []
    rows = [(flight.name, flight.stage, flight.why) for flight in flights]
    session.output.show(view, table(("DRONE", "STAGE", "WHY"), rows))
    failed = [f"{flight.name}: {flight.why or flight.stage}" for flight in flights if flight.stage in _FAILED]
    if failed:
        raise NotDone("; ".join(failed))


@plan.command("run")
@click.argument("id")
@click.option("--name", help="For people.")
@click.option("--ask-first", is_flag=True, help="A changed plan waits for an answer before it is flown.")
@_CLOUD_LOSS
@click.option("--no-wait", is_flag=True, help="End when it is started.")
@connected
async def fly(
    session: Session, id: str, name: str | None, ask_first: bool, on_cloud_loss: str | None, no_wait: bool
) -> None:
    """Fly the plan as a mission run: watched by the server, and planned anew when a drone fails.

    Ctrl-C ends the watching only: the run goes on.
    """
    asked = {"plan": id, "name": name, "mode": "askFirst" if ask_first else None, "on_cloud_loss": on_cloud_loss}
    plan = AsyncPlan(await session.server.rest.get_plan(id), session.server.rest, session.server.stream)
    started = await plan.start_run(RunStartRequest.model_validate(asked))
    if no_wait:
        session.output.show(started.view, f"The run {started.id} is started.")
    else:
        await watched(session, started)


@plan.command()
@click.argument("id")
@yes_option
@connected
async def delete(session: Session, id: str, yes: bool) -> None:
    """Cancel the search of a plan, or forget one that has ended."""
    agreed(yes, f"Delete the plan {id}?")
    await session.server.rest.remove_plan(id)
    session.output.say(f"Plan {id}: deleted.")


def _show(session: Session, view: PlanView) -> None:
    session.output.show(view, _drawn(view))
    found = view.result
    if found is None or session.output.as_json:
        return
    for unserved in found.unserved:
        session.output.say(f"Left out: {unserved.waypoint}: {unserved.why}")
    for fault in found.faults:
        session.output.note(f"It must not be flown: {fault}")
    session.output.say(f"Plan {view.id}: {found.ends_seconds:.0f} s. Next: dronectl plan run {view.id}")


def _drawn(view: PlanView) -> Table:
    found = view.result
    if found is None:
        return table(("PLAN", "STATE", "WHY"), [(view.id, view.state, view.why)])
    return table(
        ("DRONE", "WAYPOINTS", "METERS", "SECONDS", "BATTERY %"),
        [
            (
                tour.name,
                " ".join(stop.waypoint for stop in tour.stops) or "-",
                f"{tour.distance:.0f}",
                f"{tour.ends_seconds:.0f}",
                None if tour.battery_share is None else f"{100 * tour.battery_share:.0f}",
            )
            for tour in found.tours
        ],
    )
