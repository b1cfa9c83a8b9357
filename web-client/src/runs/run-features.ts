import type { Feature, FeatureCollection, Position } from 'geojson';
import type { Barrier, MissionRun, RunDrone } from '../api/runs';
import type { Zone } from '../api/zones';
import type { Coordinates } from '../geo/coordinates';
import { TOUR_TONES } from '../tours/tour-text';
import { WAYPOINT_LOOKS } from './run-text';

/** Further drones begin anew. */
export function toneOf(run: MissionRun, drone: string): number {
  const at = run.drones.findIndex((one) => one.id === drone);
  return Math.max(0, at) % TOUR_TONES;
}

/** The way that each drone still has, the waypoints by their state, and what was marked and not sent. */
export function runFeatures(
  run: MissionRun | null,
  chosen: string | null,
  marks: readonly Coordinates[],
  startOf: (drone: string) => Coordinates | null,
): FeatureCollection {
  if (run === null) {
    return { type: 'FeatureCollection', features: [] };
  }
  const places = new Map(run.waypoints.map((waypoint) => [waypoint.id, waypoint]));
  const features = [
    ...run.drones.flatMap((drone) => wayOf(run, drone, places, startOf(drone.id))),
    ...run.waypoints.map((waypoint) => {
      const { tone, mark } = WAYPOINT_LOOKS[waypoint.state];
      const label = mark === '' ? waypoint.id : `${waypoint.id} ${mark}`;
      return point(waypoint, { id: waypoint.id, label, look: tone, chosen: waypoint.id === chosen });
    }),
    ...marks.map((place) => point(place, { label: '+', look: 'mark', chosen: true })),
  ];
  return { type: 'FeatureCollection', features };
}

/** The barriers of the run that are not drawn as zones already. */
export function ownBarriers(run: MissionRun | null, zones: readonly Zone[]): Barrier[] {
  const drawn = new Set(zones.map(shapeOf));
  // A barrier that binds several drones is listed once for each of them.
  const others = new Map((run?.barriers ?? []).map((barrier) => [shapeOf(barrier), barrier]));
  return [...others].filter(([shape]) => !drawn.has(shape)).map(([, barrier]) => barrier);
}

function shapeOf({ geometry, properties }: Zone | Barrier): string {
  return JSON.stringify([properties.kind, properties.radius, geometry.type, geometry.coordinates]);
}

function wayOf(
  run: MissionRun,
  drone: RunDrone,
  places: ReadonlyMap<string, Coordinates>,
  start: Coordinates | null,
): Feature[] {
  const next = drone.next.map((id) => places.get(id)).filter((place) => place !== undefined);
  const way = start === null ? next : [start, ...next];
  if (run.state === 'over' || next.length === 0 || way.length < 2) {
    return [];
  }
  const properties = { tone: toneOf(run, drone.id), label: drone.name };
  return [
    { type: 'Feature', properties, geometry: { type: 'LineString', coordinates: way.map(positionOf) } },
  ];
}

function point(place: Coordinates, properties: Record<string, unknown>): Feature {
  return { type: 'Feature', properties, geometry: { type: 'Point', coordinates: positionOf(place) } };
}

function positionOf({ latitude, longitude }: Coordinates): Position {
  return [longitude, latitude];
}
