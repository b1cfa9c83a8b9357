import type { Drone } from '../api/types';
import { placeOf } from '../fleet/place';
import { distanceMeters } from '../geo/distance';

const MOST_POINTS = 600;
const LEAST_STEP_METERS = 1;
/** Further in one report than anything flies, a replay at a hundred times its speed included. */
const IMPLAUSIBLE_STEP_METERS = 500;
/** Nothing flies that far between two reports: a simulator was moved or the GPS found itself. */
const JUMP_METERS = 5_000;
/** Silent for as long as makes a drone lost: its way meanwhile is unknown. */
const LONGEST_SILENCE_MILLISECONDS = 5_000;

type LonLat = [number, number];

interface Track {
  points: { at: LonLat; begins: boolean }[];
  reportedAt: number | null;
  /** The next point begins a new line. */
  broken: boolean;
}

/**
 * The track of each drone since this page was opened: at most 600 points each, the oldest go first. A line is broken
 * where the way between two points is unknown.
 */
export class Trails {
  readonly #tracks = new Map<string, Track>();

  add(drone: Drone): void {
    const place = placeOf(drone);
    if (place === null) {
      return;
    }
    const track = this.#tracks.get(drone.id) ?? { points: [], reportedAt: null, broken: true };
    this.#tracks.set(drone.id, track);
    const reportedAt = Date.parse(drone.link.lastHeard ?? drone.lastUpdate ?? '');
    if (track.reportedAt !== null && reportedAt - track.reportedAt > LONGEST_SILENCE_MILLISECONDS) {
      track.broken = true;
    }
    track.reportedAt = Number.isNaN(reportedAt) ? track.reportedAt : reportedAt;
    extend(track, [place.longitude, place.latitude]);
  }

  remove(id: string): void {
    this.#tracks.delete(id);
  }

  /** The unbroken parts of the way, oldest first. */
  of(id: string): readonly (readonly LonLat[])[] {
    const parts: LonLat[][] = [];
    for (const { at, begins } of this.#tracks.get(id)?.points ?? []) {
      if (begins || parts.length === 0) {
        parts.push([]);
      }
      parts.at(-1)?.push(at);
    }
    return parts;
  }
}

function extend(track: Track, at: LonLat): void {
  const step = stepMeters(track.points.at(-1)?.at, at);
  if (step < LEAST_STEP_METERS) {
    return;
  }
  if (step > JUMP_METERS) {
    track.points.length = 0;
  }
  track.points.push({ at, begins: track.broken || step > IMPLAUSIBLE_STEP_METERS });
  track.broken = false;
  if (track.points.length > MOST_POINTS) {
    track.points.shift();
  }
}

function stepMeters(from: LonLat | undefined, to: LonLat): number {
  return from === undefined
    ? Infinity
    : distanceMeters({ latitude: from[1], longitude: from[0] }, { latitude: to[1], longitude: to[0] });
}
