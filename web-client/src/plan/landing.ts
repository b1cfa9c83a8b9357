import type { AltitudeReference, MissionItem, PlannedItem } from '../api/types';
import type { Coordinates } from '../geo/coordinates';

/** The place where a planned mission lands; `place` is null until it is chosen. Altitude of its ground, metres. */
export interface DraftLanding {
  place: Coordinates | null;
  /** Null: as high as home. */
  altitude: number | null;
  altitudeReference: AltitudeReference;
  /** The key of the waypoint that leads down to it; further waypoints are put before that one. */
  approach: number | null;
}

/** On the map the landing place is moved like a waypoint; those have keys from 1. */
export const LANDING_KEY = 0;

export type LandItem = Extract<PlannedItem, { type: 'land' }>;

export function emptyLanding(): DraftLanding {
  return { place: null, altitude: null, altitudeReference: 'home', approach: null };
}

export function landItem(landing: DraftLanding | null): LandItem {
  const place = landing?.place ?? null;
  if (landing === null || place === null) {
    return { type: 'land' };
  }
  const item: LandItem = { type: 'land', latitude: place.latitude, longitude: place.longitude };
  return landing.altitude === null
    ? item
    : { ...item, altitude: landing.altitude, altitudeReference: landing.altitudeReference };
}

/** Null: it lands where it is. */
export function landingOf(item: LandItem): DraftLanding | null {
  const place = landingPlace(item);
  return place === null
    ? null
    : {
        ...emptyLanding(),
        place,
        altitude: item.altitude ?? null,
        altitudeReference: item.altitudeReference ?? 'home',
      };
}

/** The place of an item that lands at one. */
export function landingPlace(item: MissionItem | undefined): Coordinates | null {
  return item?.type === 'land' && typeof item.latitude === 'number' && typeof item.longitude === 'number'
    ? { latitude: item.latitude, longitude: item.longitude }
    : null;
}
