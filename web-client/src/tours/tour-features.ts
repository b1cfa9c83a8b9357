import type { Feature, FeatureCollection, Position } from 'geojson';
import type { FleetPlan, PlanPlace } from '../api/plans';
import type { Coordinates } from '../geo/coordinates';
import { toneOf } from './tour-text';

/** One line for each drone: straight from waypoint to waypoint during the search, then as it is flown. */
export function tourFeatures(
  plan: FleetPlan | null,
  places: ReadonlyMap<string, Coordinates>,
  startOf: (drone: string) => Coordinates | null,
): FeatureCollection {
  if (plan === null || plan.state === 'cancelled' || plan.state === 'failed') {
    return { type: 'FeatureCollection', features: [] };
  }
  const features = plan.result === null ? sketched(plan, places, startOf) : flown(plan, startOf);
  return { type: 'FeatureCollection', features: features.filter((one) => one !== null) };
}

function sketched(
  plan: FleetPlan,
  places: ReadonlyMap<string, Coordinates>,
  startOf: (drone: string) => Coordinates | null,
): (Feature | null)[] {
  return (plan.orders ?? []).map(({ drone, waypoints }) => {
    const start = startOf(drone);
    const visits = waypoints.map((id) => places.get(id)).filter((place) => place !== undefined);
    const way = start === null ? visits : [start, ...visits, start];
    return visits.length === 0 ? null : line(plan, drone, way.map(positionOf));
  });
}

function flown(plan: FleetPlan, startOf: (drone: string) => Coordinates | null): (Feature | null)[] {
  const tours = (plan.result?.tours ?? []).flatMap((tour) => {
    const start = startOf(tour.drone);
    const way: (Coordinates | PlanPlace)[] = [
      ...(start === null ? [] : [start]),
      ...tour.stops.flatMap((stop) => [...stop.via, stop]),
      ...tour.back,
    ];
    const stops = tour.stops.map((stop) =>
      mark(stop, { tone: toneOf(plan, tour.drone), label: stop.waypoint }),
    );
    return [line(plan, tour.drone, way.map(positionOf)), ...stops];
  });
  const unserved = (plan.result?.unserved ?? []).map((one) =>
    mark(one.place, { unserved: true, label: `${one.waypoint} ✕` }),
  );
  return [...tours, ...unserved];
}

function mark(place: Coordinates, properties: Record<string, unknown>): Feature {
  return { type: 'Feature', properties, geometry: { type: 'Point', coordinates: positionOf(place) } };
}

function line(plan: FleetPlan, drone: string, coordinates: Position[]): Feature | null {
  const label = plan.drones.find((one) => one.id === drone)?.name ?? drone;
  return coordinates.length < 2
    ? null
    : {
        type: 'Feature',
        properties: { tone: toneOf(plan, drone), label },
        geometry: { type: 'LineString', coordinates },
      };
}

function positionOf({ latitude, longitude }: Coordinates): Position {
  return [longitude, latitude];
}
