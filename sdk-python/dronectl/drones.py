"""dronectl drones and watch: how the drones are."""

import asyncio
import time

import click
from rich.live import Live
from rich.table import Table

from dronectl.command import DRONE, Command, connected
from dronectl.output import Output, place, table, text
from dronectl.settings import Session, chosen
from dronemap.contract.models import DroneView

#: Narrower terminals do without the last columns.
_WITH_PLACE = 125
_COLUMNS = ("NAME", "ID", "LINK", "FLIGHT", "ARMED", "MODE", "HEIGHT m", "SPEED m/s", "BATTERY %", "CONTROL", "PLACE")
#: A person reads no faster.
_DRAW_SECONDS = 0.25


@click.command(cls=Command)
@connected
async def drones(session: Session) -> None:
    """List the drones that you may see."""
    answer = await session.server.rest.list_drones()
    session.output.show(answer, _drawn(answer.drones, session.output.console.width))


@click.command(cls=Command)
@click.argument("names", metavar="[DRONE]...", nargs=-1, type=DRONE)
@connected
async def watch(session: Session, names: tuple[str, ...]) -> None:
    """Watch drones, all or the named ones, until Ctrl-C.

    With --json each change is one line; into a file or pipe, each change of what the table shows.
    """
    known = (await session.server.rest.list_drones()).drones
    wanted = {chosen(known, name).id for name in names}
    await session.server.stream.ready()
    try:
        if session.output.console.is_terminal and not session.output.as_json:
            await _table(session, wanted)
        else:
            await _lines(session, wanted)
    except asyncio.CancelledError:
        # With --timeout it was long enough; that is no failure.
        if session.interrupted:
            raise


async def _table(session: Session, wanted: set[str]) -> None:
    stream = session.server.stream
    with Live(console=session.output.console, auto_refresh=False) as live:
        while True:
            seen = [change.state for change in stream.drones.values() if not wanted or change.id in wanted]
            drawn = _drawn(seen, session.output.console.width)
            if not stream.connected:
                drawn.caption = "The connection to the server is interrupted; this is how it was."
            live.update(drawn, refresh=True)
            await asyncio.sleep(_DRAW_SECONDS)


async def _lines(session: Session, wanted: set[str]) -> None:
    told: dict[str, str] = {}
    with session.server.changes() as changes:
        async for change in changes:
            if wanted and change.id not in wanted:
                continue
            if session.output.as_json:
                session.output.json_line(change.state)
            else:
                _tell(session.output, told, change.state)


def _tell(output: Output, told: dict[str, str], state: DroneView) -> None:
    flown = (state.link.state, state.flight, "armed" if state.armed else "disarmed", state.mode, _holder(state))
    line = " ".join(text(part) for part in (state.name, *flown) if part)
    if told.get(state.id) != line:
        told[state.id] = line
        output.say(f"{time.strftime('%H:%M:%S')} {line}")


def _drawn(states: list[DroneView], width: int) -> Table:
    most = len(_COLUMNS) if width >= _WITH_PLACE else len(_COLUMNS) - 1
    return table(_COLUMNS[:most], [_row(state)[:most] for state in sorted(states, key=lambda state: state.name)])


def _row(state: DroneView) -> tuple[object, ...]:
    position, motion, battery = state.position, state.motion, state.battery
    return (
        state.name,
        state.id,
        state.link.state,
        state.flight,
        state.armed,
        state.mode,
        position.altitude_above_home if position else None,
        motion.ground_speed if motion else None,
        battery.percent if battery else None,
        _holder(state),
        place(position.latitude, position.longitude) if position else None,
    )


def _holder(state: DroneView) -> str | None:
    return state.control.holder or ("pilot" if state.control.state == "pilot" else None)
