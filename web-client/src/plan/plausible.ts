import type { MissionItem } from '../api/types';
import type { Coordinates } from '../geo/coordinates';
import { distanceMeters, wayLengthMeters } from '../geo/distance';
import { landingPlace } from './landing';
import { distance, fixed } from '../ui/format';

export const FAR_METERS = 10_000;
const LONG_LEG_METERS = 20_000;
const LONG_WAY_METERS = 50_000;
const HIGH_METERS = 500;

/** Something in a mission that may be a mistake. `key` stays the same while the drone moves, the sentence may not. */
export interface PlausibilityWarning {
  key: string;
  sentence: string;
}

interface Place extends Coordinates {
  number: number;
}

/**
 * Finds what may be a mistake in a mission, to be confirmed before it is flown. Nothing of it is forbidden.
 * Items are the whole mission as on the vehicle; `from` is where the drone is, when that is known.
 */
export function plausibilityWarnings(
  items: readonly MissionItem[],
  from: Coordinates | null,
): PlausibilityWarning[] {
  const places = items.flatMap((item, index): Place[] =>
    item.type === 'waypoint'
      ? [{ number: index + 1, latitude: item.latitude, longitude: item.longitude }]
      : landings(item, index),
  );
  return [...farPlaces(places, from), ...longLeg(places), ...longWay(places), ...oddAltitudes(items)];
}

function landings(item: MissionItem, index: number): Place[] {
  const place = landingPlace(item);
  return place === null ? [] : [{ number: index + 1, ...place }];
}

function farPlaces(places: readonly Place[], from: Coordinates | null): PlausibilityWarning[] {
  if (from === null) {
    return [];
  }
  const far = places
    .map((place) => ({ place, meters: distanceMeters(from, place) }))
    .filter(({ meters }) => meters > FAR_METERS)
    .sort((a, b) => b.meters - a.meters);
  const [farthest] = far;
  if (farthest === undefined) {
    return [];
  }
  const { place, meters } = farthest;
  const sentence =
    far.length === 1
      ? `Item ${place.number} is ${distance(meters)} away from the drone.`
      : `${far.length} places are more than ${FAR_METERS / 1000} km away from the drone; item ${place.number} is ${distance(meters)} away.`;
  return [{ key: `far ${nameOf(place)}`, sentence }];
}

function longLeg(places: readonly Place[]): PlausibilityWarning[] {
  for (let i = 1; i < places.length; i++) {
    const start = places[i - 1] as Place;
    const end = places[i] as Place;
    const meters = distanceMeters(start, end);
    if (meters > LONG_LEG_METERS) {
      return [
        {
          key: `leg ${nameOf(start)} ${nameOf(end)}`,
          sentence: `From item ${start.number} to item ${end.number} it is ${distance(meters)}.`,
        },
      ];
    }
  }
  return [];
}

function longWay(places: readonly Place[]): PlausibilityWarning[] {
  const meters = wayLengthMeters(places);
  return meters > LONG_WAY_METERS
    ? [{ key: `way ${distance(meters)}`, sentence: `The whole way is ${distance(meters)}.` }]
    : [];
}

function oddAltitudes(items: readonly MissionItem[]): PlausibilityWarning[] {
  return items.flatMap((item, index) => {
    if (item.type !== 'waypoint' || item.altitudeReference === 'amsl') {
      return [];
    }
    const { altitude } = item;
    const words =
      altitude < 0
        ? `is at ${fixed(altitude)} m, lower than home`
        : altitude > HIGH_METERS
          ? `is ${fixed(altitude)} m above home`
          : null;
    return words === null
      ? []
      : [{ key: `altitude ${index} ${altitude}`, sentence: `Item ${index + 1} ${words}.` }];
  });
}

function nameOf(place: Place): string {
  return `${place.number} ${place.latitude} ${place.longitude}`;
}
