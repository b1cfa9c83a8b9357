import type { MissionItem } from '../api/types';
import type { Coordinates } from '../geo/coordinates';
import { distanceMeters, wayLengthMeters } from '../geo/distance';
import { distance, fixed } from '../ui/format';

export const FAR_METERS = 10_000;
const LONG_LEG_METERS = 20_000;
const LONG_WAY_METERS = 50_000;
const HIGH_METERS = 500;

interface Place extends Coordinates {
  number: number;
}

/**
 * What in a mission may be a slip of the hand: sentences to look at before it is flown. Nothing of it is forbidden.
 * Items are the whole mission as on the vehicle; `from` is where the drone is, when that is known.
 */
export function doubtsAbout(items: readonly MissionItem[], from: Coordinates | null): string[] {
  const places = items.flatMap((item, index): Place[] =>
    item.type === 'waypoint'
      ? [{ number: index + 1, latitude: item.latitude, longitude: item.longitude }]
      : [],
  );
  return [farPlaces(places, from), longLeg(places), longWay(places), ...oddAltitudes(items)].filter(
    (sentence) => sentence !== null,
  );
}

function farPlaces(places: readonly Place[], from: Coordinates | null): string | null {
  const far =
    from === null
      ? []
      : places
          .map((place) => ({ number: place.number, meters: distanceMeters(from, place) }))
          .filter(({ meters }) => meters > FAR_METERS);
  const farthest = far.reduce<{ number: number; meters: number } | null>(
    (most, one) => (most === null || one.meters > most.meters ? one : most),
    null,
  );
  if (farthest === null) {
    return null;
  }
  return far.length === 1
    ? `Item ${farthest.number} is ${distance(farthest.meters)} away from the drone.`
    : `${far.length} waypoints are more than ${FAR_METERS / 1000} km away from the drone; item ${farthest.number} is ${distance(farthest.meters)} away.`;
}

function longLeg(places: readonly Place[]): string | null {
  for (let i = 1; i < places.length; i++) {
    const start = places[i - 1] as Place;
    const end = places[i] as Place;
    const meters = distanceMeters(start, end);
    if (meters > LONG_LEG_METERS) {
      return `From item ${start.number} to item ${end.number} it is ${distance(meters)}.`;
    }
  }
  return null;
}

function longWay(places: readonly Place[]): string | null {
  const meters = wayLengthMeters(places);
  return meters > LONG_WAY_METERS ? `The whole way is ${distance(meters)}.` : null;
}

function oddAltitudes(items: readonly MissionItem[]): string[] {
  return items.flatMap((item, index) => {
    if (item.type !== 'waypoint' || item.altitudeReference === 'amsl') {
      return [];
    }
    const { altitude } = item;
    if (altitude < 0) {
      return [`Item ${index + 1} is at ${fixed(altitude)} m, lower than home.`];
    }
    return altitude > HIGH_METERS ? [`Item ${index + 1} is ${fixed(altitude)} m above home.`] : [];
  });
}
