import type { Drone } from '../api/types';
import { placeOf } from '../fleet/place';
import { distanceMeters } from '../geo/distance';

const MOST_POINTS = 600;
const LEAST_STEP_METERS = 1;
const JUMP_METERS = 5_000;

/** Where each drone has been since this page was opened: at most 600 points each, the oldest go first. */
export class Trails {
  readonly #points = new Map<string, [number, number][]>();

  add(drone: Drone): void {
    const place = placeOf(drone);
    if (place === null) {
      return;
    }
    const { latitude, longitude } = place;
    const points = this.#points.get(drone.id) ?? [];
    this.#points.set(drone.id, points);
    const last = points.at(-1);
    const step =
      last === undefined
        ? Infinity
        : distanceMeters({ latitude: last[1], longitude: last[0] }, { latitude, longitude });
    if (step < LEAST_STEP_METERS) {
      return;
    }
    if (step > JUMP_METERS) {
      // Nothing flies that far between two reports: a simulator was moved or the GPS found itself.
      points.length = 0;
    }
    points.push([longitude, latitude]);
    if (points.length > MOST_POINTS) {
      points.shift();
    }
  }

  remove(id: string): void {
    this.#points.delete(id);
  }

  of(id: string): readonly [number, number][] {
    return this.#points.get(id) ?? [];
  }
}
