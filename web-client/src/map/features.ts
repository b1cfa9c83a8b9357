import type { Feature, FeatureCollection, Geometry, Point, Position } from 'geojson';
import type { Drone, Home, MissionItem } from '../api/types';
import { landsElsewhere } from '../fleet/outlook';
import { placeOf } from '../fleet/place';
import { statusOf } from '../fleet/drone-status';
import type { Coordinates } from '../geo/coordinates';
import type { Draft } from '../plan/draft';
import { LANDING_KEY, landingPlace } from '../plan/landing';
import { itemNumber, waypointNumber } from '../plan/numbering';
import { age } from '../ui/format';

/**
 * Drones as one layer: heading, state ring, label; stale ones fade and say how old they are. `cut`: the page has no connection
 * to the cloud, so that all of them are.
 */
export function droneFeatures(
  drones: readonly Drone[],
  selectedId: string | null,
  silenceOf: (drone: Drone) => number | null,
  cut = false,
): FeatureCollection<Point> {
  return collect(
    drones.flatMap((drone) => {
      const place = placeOf(drone);
      if (place === null) {
        return [];
      }
      const selected = drone.id === selectedId;
      return [
        point([place.longitude, place.latitude], droneProperties(drone, selected, silenceOf(drone), cut)),
      ];
    }),
  );
}

function droneProperties(
  drone: Drone,
  selected: boolean,
  silence: number | null,
  cut: boolean,
): Record<string, unknown> {
  const tone = cut ? 'neutral' : statusOf(drone).tone;
  const { state } = drone.link;
  const heading = headingOf(drone);
  const shape = heading === null ? 'dot' : 'arrow';
  return {
    id: drone.id,
    icon: `drone|${shape}|${tone}|${state === 'lost' ? 'crossed' : 'plain'}`,
    heading: heading ?? 0,
    selected,
    opacity: cut || state !== 'live' ? 0.55 : 1,
    label: drone.replay ? `${drone.name} · replay` : drone.name,
    age: ageText(drone, silence, cut),
    rank: selected ? 0 : 1,
  };
}

function headingOf({ motion, attitude }: Drone): number | null {
  return motion?.heading ?? attitude?.yaw ?? null;
}

/** The age of a silent drone's position; a recording that was played to its end does not age. */
function ageText({ link }: Drone, silence: number | null, cut: boolean): string {
  const old = link.state === 'suspect' || link.state === 'lost' || (cut && link.state === 'live');
  return old ? age(silence) : '';
}

export function trailFeatures(
  drones: readonly Drone[],
  selectedId: string | null,
  trailOf: (id: string) => readonly (readonly Position[])[],
): FeatureCollection {
  return collect(
    drones.flatMap((drone) =>
      trailOf(drone.id)
        .filter((part) => part.length > 1)
        .map((part) => line([...part], { selected: drone.id === selectedId })),
    ),
  );
}

/** The mission that the vehicle itself holds: what is reached, what comes now, what is to come. */
export function missionFeatures(drone: Drone | null): FeatureCollection {
  const mission = drone?.mission;
  if (!drone || !mission?.items) {
    return collect([]);
  }
  const reached = new Set(mission.reached);
  const points = mission.items.flatMap((item, index) => {
    const place = item.type === 'waypoint' ? item : landingPlace(item);
    return place === null
      ? []
      : [{ index, at: positionOf(place), words: item.type === 'land' ? LANDING_WORDS : '' }];
  });
  const features: Feature[] = points.map(({ index, at, words }) =>
    point(at, {
      label: String(itemNumber(index)),
      words,
      state: reached.has(index)
        ? 'reached'
        : mission.running && mission.current === index
          ? 'current'
          : 'ahead',
    }),
  );
  return collect([
    ...wayOf(
      points.map(({ at }) => at),
      mission.items.at(-1),
      drone.home,
    ),
    ...features,
  ]);
}

const LANDING_WORDS = 'Land';

/** The plan: violet, because it is not yet true; without a way where it has no order yet. */
export function draftFeatures(draft: Draft | null, drone: Drone | null, ordered = true): FeatureCollection {
  if (draft === null) {
    return collect([]);
  }
  const waypoints = draft.waypoints.map((waypoint, index) =>
    point(positionOf(waypoint), {
      key: waypoint.key,
      label: String(waypointNumber(draft, drone, index)),
      words: '',
    }),
  );
  return collect(
    ordered ? [...draftWay(draft, drone), ...waypoints, ...draftLanding(draft, drone)] : waypoints,
  );
}

function landingOfDraft({ ending, landing }: Draft): Coordinates | null {
  return ending === 'land' ? (landing?.place ?? null) : null;
}

function draftWay(draft: Draft, drone: Drone | null): Feature[] {
  const place = landingOfDraft(draft);
  const points = [...draft.waypoints, ...(place === null ? [] : [place])].map(positionOf);
  const ending: MissionItem | undefined =
    draft.ending === 'returnToLaunch' ? { type: 'returnToLaunch' } : undefined;
  return wayOf(points, ending, drone?.home ?? null);
}

function draftLanding(draft: Draft, drone: Drone | null): Feature[] {
  const place = landingOfDraft(draft);
  const label = String(waypointNumber(draft, drone, draft.waypoints.length));
  return place === null ? [] : [point(positionOf(place), { key: LANDING_KEY, label, words: LANDING_WORDS })];
}

/** The place where a drone in the air would land, and the way there; nothing when it is below the drone. */
export function landingFeatures(drone: Drone | null): FeatureCollection {
  const here = placeOf(drone);
  const there = landsElsewhere(drone);
  if (here === null || there === null) {
    return collect([]);
  }
  const end: Position = [there.longitude, there.latitude];
  return collect([line([[here.longitude, here.latitude], end], {}), point(end, { label: 'lands here' })]);
}

export function homeFeatures(drone: Drone | null): FeatureCollection {
  return placeFeatures(drone?.home ?? null);
}

export function placeFeatures(place: Coordinates | null): FeatureCollection {
  return collect(place === null ? [] : [point([place.longitude, place.latitude], {})]);
}

function wayOf(points: Position[], last: MissionItem | undefined, home: Home | null): Feature[] {
  const way =
    last?.type === 'returnToLaunch' && home !== null ? [...points, [home.longitude, home.latitude]] : points;
  return way.length < 2 ? [] : [line(way, {})];
}

function positionOf(place: Coordinates): Position {
  return [place.longitude, place.latitude];
}

function point(coordinates: Position, properties: Record<string, unknown>): Feature<Point> {
  return { type: 'Feature', properties, geometry: { type: 'Point', coordinates } };
}

function line(coordinates: Position[], properties: Record<string, unknown>): Feature {
  return { type: 'Feature', properties, geometry: { type: 'LineString', coordinates } };
}

function collect<G extends Geometry>(features: Feature<G>[]): FeatureCollection<G> {
  return { type: 'FeatureCollection', features };
}
