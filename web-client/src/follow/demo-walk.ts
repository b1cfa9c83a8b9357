import type { Coordinates } from '../geo/coordinates';
import track from './demo-track.json';
import { moved, type Fix, type SourceListener, type TargetSource } from './fix';

const SECOND = 1_000;
/** Like a phone's under open sky. */
const ACCURACY_METERS = 4;

/** Metres east and north of where it begins, one entry a second; it ends where it began. */
export const TRACK: readonly { east: number; north: number }[] = track.map(([east = 0, north = 0]) => ({
  east: east / 10,
  north: north / 10,
}));

/** The position of the recorded walk after so many seconds, from a given begin; it repeats endlessly. */
export function demoFix(begin: Coordinates, seconds: number, at: number): Fix {
  const index = Math.floor(seconds) % (TRACK.length - 1);
  const here = TRACK[index] as (typeof TRACK)[number];
  const next = TRACK[index + 1] as (typeof TRACK)[number];
  const east = next.east - here.east;
  const north = next.north - here.north;
  return {
    at,
    ...moved(begin, here.east, here.north),
    accuracy: ACCURACY_METERS,
    speed: Math.hypot(east, north),
    course: ((Math.atan2(east, north) * 180) / Math.PI + 360) % 360,
  };
}

/** For people indoors: a recorded walk stands for the phone. */
export class DemoWalk implements TargetSource {
  readonly #begin: Coordinates;

  constructor(begin: Coordinates) {
    this.#begin = begin;
  }

  start(listener: SourceListener): () => void {
    const began = Date.now();
    const emit = (): void => {
      const now = Date.now();
      listener.onFix(demoFix(this.#begin, (now - began) / SECOND, now));
    };
    listener.onLocating('on');
    emit();
    const handle = setInterval(emit, SECOND);
    return () => clearInterval(handle);
  }
}
