"""dronectl follow: drones that follow a phone, or whatever knows where it is."""

import asyncio
from pathlib import Path

import click

from dronectl.command import DRONE, Group, NumbersCommand, connected
from dronectl.failure import NotDone
from dronectl.output import Working, table
from dronectl.reading import FILE, fitted
from dronectl.settings import Session
from dronectl.track import Track, read_track
from dronemap import DronemapError
from dronemap.contract.models import FollowOpenRequest, FollowView
from dronemap.follow import AsyncFollow

#: As the server wants to hear of it.
_REPORT_SECONDS = 1.0
_WALKING = 1.4
_SIDES = ("behind", "ahead", "fixed", "orbit")


@click.group(cls=Group)
def follow() -> None:
    """Drones that follow a phone.

    Such a drone keeps its place beside positions that are reported once a second.
    """


@follow.command("list")
@connected
async def list_follows(session: Session) -> None:
    """List the follows."""
    answer = await session.server.rest.list_follows()
    rows = [
        (view.id, view.name, view.drone_name, view.state, view.owner, view.end or view.note) for view in answer.follows
    ]
    session.output.show(answer, table(("ID", "NAME", "DRONE", "STATE", "OWNER", "NOTE"), rows))


@follow.command("open", cls=NumbersCommand)
@click.argument("latitude", type=float)
@click.argument("longitude", type=float)
@click.option("-d", "--drone", type=DRONE, metavar="DRONE", help="Name or id; else the best of the warehouse.")
@click.option("--minutes", type=float, help="How long it shall last, 1 to 60; else 10.")
@click.option("--name", help="For people.")
@click.option("--side", type=click.Choice(_SIDES), help="Where the drone stays; else behind.")
@click.option("--distance", type=float, help="Metres from the phone, 0 to 200; else 8.")
@click.option("--height", type=float, help="Metres above the drone's home, 5 to 120; else 15.")
@click.option("--bearing", type=float, help="fixed: on which side, degrees from north.")
@click.option("--turn", type=float, help="orbit: degrees a second clockwise, -30 to 30.")
@connected
async def open_follow(
    session: Session,
    latitude: float,
    longitude: float,
    drone: str | None,
    minutes: float | None,
    name: str | None,
    side: str | None,
    distance: float | None,
    height: float | None,
    bearing: float | None,
    turn: float | None,
) -> None:
    """Ask for a drone that follows from there on. It stays on the ground until start."""
    place = _some({"side": side, "distance": distance, "height": height, "bearing": bearing, "turn": turn})
    view = await _opened(session, latitude, longitude, drone, {"minutes": minutes, "name": name, "place": place})
    session.output.show(view, f"{_sentence(view)} Next: dronectl follow start {view.id}")


@follow.command()
@click.argument("id")
@connected
async def start(session: Session, id: str) -> None:
    """Start it: the drone takes off and comes."""
    _changed(session, await session.server.rest.start_follow(id))


@follow.command(cls=NumbersCommand)
@click.argument("id")
@click.argument("latitude", type=float)
@click.argument("longitude", type=float)
@click.option("--accuracy", type=float, help="Metres; else 10.")
@connected
async def report(session: Session, id: str, latitude: float, longitude: float, accuracy: float | None) -> None:
    """Say where the phone is, once."""
    receipt = await (await _known(session, id)).report(latitude, longitude, accuracy=accuracy)
    session.output.show(receipt, f"{receipt.taken} taken.")


@follow.command()
@click.argument("id")
@connected
async def pause(session: Session, id: str) -> None:
    """Have the drone hold."""
    _changed(session, await session.server.rest.pause_follow(id))


@follow.command("continue")
@click.argument("id")
@connected
async def go_on(session: Session, id: str) -> None:
    """Let a paused follow go on."""
    _changed(session, await session.server.rest.continue_follow(id))


@follow.command()
@click.argument("id")
@connected
async def stop(session: Session, id: str) -> None:
    """Stop it: the drone flies home."""
    _changed(session, await session.server.rest.stop_follow(id))


@follow.command()
@click.argument("id")
@connected
async def cancel(session: Session, id: str) -> None:
    """Give the drone back before it has taken off."""
    _changed(session, await session.server.rest.cancel_follow(id))


@follow.command()
@click.argument("file", type=FILE)
@click.option("-d", "--drone", type=DRONE, metavar="DRONE", help="Name or id; else the best of the warehouse.")
@click.option("--speed", type=click.FloatRange(0.1, 15), default=_WALKING, help="m/s, where FILE has no times.")
@connected
async def walk(session: Session, file: Path, drone: str | None, speed: float) -> None:
    """Have a drone follow the way in FILE, and fly home at its end.

    FILE is GPX, or CSV whose first line names latitude, longitude and perhaps seconds. Ctrl-C: the drone flies home.
    """
    track = read_track(file, speed)
    begin = track.at(0)
    # It takes off and comes first, and has to fly home.
    minutes = min(60.0, track.length / 60 + 5)
    view = await _opened(session, begin.latitude, begin.longitude, drone, {"minutes": minutes, "name": file.name[:60]})
    walked = AsyncFollow(view, session.server.rest, session.server.stream)
    session.output.note(_sentence(view))
    try:
        with session.output.working(view.name) as working:
            await walked.start()
            await _walked(walked, track, working)
            await walked.stop()
            working.say(f"{view.drone_name} flies home")
            ended = await walked.wait()
    except (asyncio.CancelledError, DronemapError):
        await _called_home(session, walked)
        raise
    session.output.show(ended, f"{view.name}: {ended.end or 'over.'}")


async def _walked(follow: AsyncFollow, track: Track, working: Working) -> None:
    """Stands at the beginning until the drone is there, and walks then."""
    loop = asyncio.get_running_loop()
    begun: float | None = None
    watching = asyncio.ensure_future(follow.wait())
    try:
        while begun is None or loop.time() - begun < track.length:
            if watching.done():
                raise NotDone(f"It is over before the way was: {watching.result().end or 'nobody says why.'}")
            if begun is None and follow.view.state == "tracking":
                begun = loop.time()
            second = 0.0 if begun is None else loop.time() - begun
            place = track.at(second)
            moving = begun is not None
            await follow.report(
                place.latitude,
                place.longitude,
                accuracy=3,
                speed=place.speed if moving else 0.0,
                course=place.course,
            )
            words = f"{follow.view.drone_name}: {follow.view.state}"
            working.say(words, second if moving else None, track.length if moving else None)
            await asyncio.sleep(_REPORT_SECONDS)
    finally:
        watching.cancel()


async def _called_home(session: Session, follow: AsyncFollow) -> None:
    try:
        view = await session.server.rest.get_follow(follow.id)
        if view.state == "over":
            return
        view = await (follow.cancel() if view.state == "allocated" else follow.stop())
    except DronemapError as e:
        session.output.note(
            f"{follow.view.drone_name} could not be called home: {e} It flies home once no positions come."
        )
    else:
        session.output.note(f"{view.drone_name}: {view.state}.")


async def _opened(
    session: Session, latitude: float, longitude: float, drone: str | None, further: dict[str, object]
) -> FollowView:
    asked: dict[str, object] = {"latitude": latitude, "longitude": longitude, **_some(further)}
    if drone is not None:
        asked["drone"] = await session.id(drone)
    return await session.server.rest.open_follow(fitted("The follow", asked, FollowOpenRequest))


async def _known(session: Session, id: str) -> AsyncFollow:
    return AsyncFollow(await session.server.rest.get_follow(id), session.server.rest, session.server.stream)


def _some(members: dict[str, object]) -> dict[str, object]:
    return {name: value for name, value in members.items() if value not in (None, {})}


def _changed(session: Session, view: FollowView) -> None:
    session.output.show(view, _sentence(view))


def _sentence(view: FollowView) -> str:
    said = view.told[-1].words if view.told else ""
    return f"{view.name} ({view.id}): {view.drone_name}, {view.state}. {said}".strip()
