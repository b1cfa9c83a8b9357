"""dronectl zones: where drones may fly and where not."""

from pathlib import Path

import click

from dronectl.command import Group, agreed, connected, yes_option
from dronectl.failure import NotDone
from dronectl.output import members, table
from dronectl.reading import FILE, content
from dronectl.settings import Session
from dronemap.contract.models import PointGeometry, PolygonGeometry, ZoneFeature


@click.group(cls=Group)
def zones() -> None:
    """Where drones may fly; each zone by its name or id."""


@zones.command("list")
@connected
async def list_zones(session: Session) -> None:
    """List the zones."""
    answer = await session.server.rest.list_zones()
    rows = [_row(zone) for zone in answer.features or []]
    session.output.show(answer, table(("NAME", "ID", "KIND", "SHAPE", "FLOOR m", "CEILING m", "FROM", "UNTIL"), rows))


@zones.command()
@click.argument("name")
@connected
async def show(session: Session, name: str) -> None:
    """Print a zone as a GeoJSON feature."""
    session.output.json(members(await _found(session, name)))


@zones.command("import")
@click.argument("file", type=FILE)
@connected
async def import_file(session: Session, file: Path) -> None:
    """Add the zones of FILE, GeoJSON, KML or KMZ; what cannot be one is named."""
    raw = content(file)
    if raw.startswith(b"PK"):
        answer = await session.server.rest.import_zones(raw, content_type="application/vnd.google-earth.kmz")
    elif raw.lstrip().startswith(b"<"):
        answer = await session.server.rest.import_zones(raw, content_type="application/vnd.google-earth.kml+xml")
    else:
        answer = await session.server.rest.import_zones(raw, content_type="application/geo+json")
    added = answer.features
    left_out = [f"Left out, {piece.name or piece.at} ({piece.at}): {piece.why}" for piece in answer.left_out]
    if len(answer.left_out) < answer.left_out_total:
        left_out.append(f"Left out are {answer.left_out_total} in all.")
    words = f"{len(added)} zones added: {', '.join(_name(zone) for zone in added)}."
    session.output.show(answer, "\n".join([words, *left_out]))


@zones.command()
@click.argument("name")
@yes_option
@connected
async def delete(session: Session, name: str, yes: bool) -> None:
    """Delete a zone."""
    zone = await _found(session, name)
    agreed(yes, f"Delete the zone {_name(zone)}?")
    await session.server.rest.delete_zone(zone.id or "")
    session.output.say(f"{_name(zone)}: deleted.")


async def _found(session: Session, name: str) -> ZoneFeature:
    zones = (await session.server.rest.list_zones()).features or []
    fitting = [zone for zone in zones if zone.id == name] or [zone for zone in zones if _name(zone) == name]
    if not fitting:
        names = ", ".join(_name(zone) for zone in zones) or "none"
        raise NotDone(f"There is no zone '{name}'; there are: {names}.")
    if len(fitting) > 1:
        ids = ", ".join(zone.id or "" for zone in fitting)
        raise click.UsageError(f"Several zones have the name '{name}': take the id of one ({ids}).")
    return fitting[0]


def _name(zone: ZoneFeature) -> str:
    return (zone.properties.name if zone.properties else None) or zone.id or ""


def _row(zone: ZoneFeature) -> tuple[object, ...]:
    bounds = zone.properties
    return (
        _name(zone),
        zone.id,
        bounds.kind if bounds else None,
        _shape(zone),
        bounds.floor if bounds else None,
        bounds.ceiling if bounds else None,
        bounds.from_ if bounds else None,
        bounds.until if bounds else None,
    )


def _shape(zone: ZoneFeature) -> str:
    if isinstance(zone.geometry, PolygonGeometry):
        return f"{len(zone.geometry.coordinates[0]) - 1} corners"
    if isinstance(zone.geometry, PointGeometry) and zone.properties and zone.properties.radius:
        return f"circle of {zone.properties.radius:g} m"
    return ""
