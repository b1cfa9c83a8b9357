"""Plans, runs and virtual drones by the Python client, flown by copters, judged by REST and the wire."""

import math
from collections.abc import Iterator
from functools import partial

import pytest
from dronemap import Dronemap, Mission, MissionFailed, Problem, models, offset

from dronemap_e2e.api import Api, Json
from dronemap_e2e.flight import Point
from dronemap_e2e.message_recorder import VehicleMessages
from dronemap_e2e.server import Server
from dronemap_e2e.vehicles import Vehicles
from dronemap_e2e.waiting import wait_for

NEAR_METERS = 4.0


@pytest.fixture
def connected(server: Server) -> Iterator[Dronemap]:
    with Dronemap.connect(server.address, server.local_key()) as made:
        yield made


@pytest.fixture
def two(api: Api, vehicles: Vehicles) -> Iterator[list[tuple[Json, VehicleMessages]]]:
    """Two copters that only this test has."""
    awake = [vehicles.wake_next() for _ in range(2)]
    yield [
        (wait_for("the copter is ready", partial(api.ready, each), 90), vehicles.wire(each)) for each in awake
    ]
    for system_id in awake:
        vehicles.silence(system_id)


def passed(wire: VehicleMessages, latitude: float, longitude: float) -> bool:
    place = Point(latitude, longitude, 0)
    return any(
        place.metres_to(h.message.lat / 1e7, h.message.lon / 1e7) < NEAR_METERS
        for h in wire.messages("GLOBAL_POSITION_INT", up=True)
    )


def test_plan_is_found_and_flown_as_a_run(
    connected: Dronemap, two: list[tuple[Json, VehicleMessages]]
) -> None:
    """End to end because two copters fly what the client has had planned."""
    home = two[0][0]["home"]
    places = [offset(home["latitude"], home["longitude"], 30 + 20 * (i % 3), 20 * (i // 3)) for i in range(6)]
    wanted = [models.PlanWaypointRequest(latitude=lat, longitude=lon, altitude=15) for lat, lon in places]
    ids = [drone["id"] for drone, _ in two]
    for id in ids:
        # A plan wants to know first how good the link is.
        connected.drone(id).wait_for(lambda state: state.link.quality.loss_long is not None, 60)
    plan = connected.plan(models.PlanRequest(drones=ids, waypoints=wanted, seconds=1))
    steps = list(plan.progress())
    assert steps[-1].state == "finished"
    assert plan.wait(10).result is not None

    run = plan.start_run()
    states = [view.state for view in run.progress()]

    assert states[-1] == "over"
    assert run.wait(10).counts.visited == len(places)
    for latitude, longitude in places:
        assert any(passed(wire, latitude, longitude) for _, wire in two)


def test_virtual_drone_flies_its_mission(
    connected: Dronemap, api: Api, copter: Json, wire: VehicleMessages
) -> None:
    """End to end because a copter of the warehouse flies for a virtual drone of the client's."""
    connected.rest.put_into_warehouse(copter["id"])
    home = copter["home"]
    places = [offset(home["latitude"], home["longitude"], north=north) for north in (25, 45)]
    mission = Mission().take_off(12)
    for latitude, longitude in places:
        mission.waypoint(latitude, longitude, 12)
    virtual = connected.add_virtual_drone("Survey", mission.return_home())
    try:
        virtual.start()
        ended = virtual.wait(180)
    finally:
        connected.rest.take_from_warehouse(copter["id"])

    assert ended.run is not None
    assert ended.run.flown == ended.run.total == len(places)
    assert all(passed(wire, *place) for place in places)
    virtual.remove()
    assert virtual.id not in [each.id for each in connected.virtual_drones()]


def test_virtual_drone_without_a_mission_is_refused(connected: Dronemap) -> None:
    """End to end because the server's own sentence comes through the client."""
    virtual = connected.add_virtual_drone("Empty")
    with pytest.raises((Problem, MissionFailed), match="mission"):
        virtual.start()
    virtual.remove()


def test_zones_and_parameters_by_their_typed_calls(connected: Dronemap, copter: Json) -> None:
    """End to end because a copter answers for its own parameters."""
    rest = connected.rest
    around = models.PointGeometry(coordinates=[8.0, 46.0])
    told = models.ZoneProperties(name="Pond", kind="exclusion", radius=50)
    zone = rest.add_zone(models.ZoneFeature(type="Feature", geometry=around, properties=told))
    assert zone.id in [each.id for each in rest.list_zones().features or []]
    rest.delete_zone(str(zone.id))
    assert zone.id not in [each.id for each in rest.list_zones().features or []]

    rest.read_parameters(copter["id"], wait=60)
    name = "RTL_ALT"
    before = value(connected, copter["id"], name)
    rest.set_parameter(copter["id"], name, models.ParameterValueRequest(value=before + 100), wait=60)
    assert math.isclose(value(connected, copter["id"], name), before + 100)


def value(connected: Dronemap, drone: str, name: str) -> float:
    found = connected.rest.list_parameters(drone, search=name).parameters or []
    return next(each.value for each in found if each.name == name)
