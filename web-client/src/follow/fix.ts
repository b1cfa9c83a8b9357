import type { Coordinates } from '../geo/coordinates';
import type { Positions } from '../api/follows';

/** One position of the target: milliseconds by the phone's clock, metres, m/s, degrees clockwise from north. */
export interface Fix extends Coordinates {
  at: number;
  accuracy: number;
  speed: number | null;
  course: number | null;
}

/** The state of locating. insecure: the page came by plain HTTP; none: this browser has no such thing. */
export type Locating = 'off' | 'asking' | 'on' | 'denied' | 'unavailable' | 'insecure' | 'none';

export interface SourceListener {
  onFix(fix: Fix): void;
  onLocating(locating: Locating): void;
}

/** A source of positions of the target: the phone's receiver, or a recorded walk. */
export interface TargetSource {
  /** Answers how to end it. */
  start(listener: SourceListener): () => void;
}

/** Moves a place by metres on the ground; good for some kilometres. */
export function moved(place: Coordinates, east: number, north: number): Coordinates {
  const metersPerDegree = 111_195;
  return {
    latitude: place.latitude + north / metersPerDegree,
    longitude: place.longitude + east / (metersPerDegree * Math.cos((place.latitude * Math.PI) / 180)),
  };
}

export function positionsOf(fixes: readonly Fix[], now: number, roundTrip: number | null): Positions {
  return {
    sent: new Date(now).toISOString(),
    ...(roundTrip === null ? {} : { roundTrip }),
    positions: fixes.map((fix) => ({
      at: new Date(fix.at).toISOString(),
      latitude: fix.latitude,
      longitude: fix.longitude,
      accuracy: fix.accuracy,
      ...(fix.speed === null || fix.course === null ? {} : { speed: fix.speed, course: fix.course }),
    })),
  };
}
