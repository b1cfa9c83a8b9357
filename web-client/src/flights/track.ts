import type { TrackPoint } from '../api/flights';

/** Further apart than this nothing is known of what lies between. */
const LONGEST_GAP_MILLISECONDS = 15_000;

/** The state of a drone at one moment. */
export interface Moment {
  longitude: number;
  latitude: number;
  heading: number | null;
  altitude: number | null;
  speed: number | null;
  battery: number | null;
  mode: string | null;
}

type Placed = TrackPoint & { latitude: number; longitude: number };

/** The track of one drone, with its state at any moment. */
export class Track {
  readonly #points: Placed[];
  readonly #times: number[];

  constructor(points: readonly TrackPoint[]) {
    this.#points = points.filter(
      (point): point is Placed => point.latitude !== null && point.longitude !== null,
    );
    this.#times = this.#points.map((point) => Date.parse(point.at));
  }

  get begin(): number | null {
    return this.#times[0] ?? null;
  }

  get end(): number | null {
    return this.#times.at(-1) ?? null;
  }

  /** The unbroken parts of the way, as a map wants them. */
  lines(): [number, number][][] {
    const lines: [number, number][][] = [];
    this.#points.forEach((point, index) => {
      const gap =
        index === 0 ? Infinity : (this.#times[index] as number) - (this.#times[index - 1] as number);
      if (gap > LONGEST_GAP_MILLISECONDS) {
        lines.push([]);
      }
      lines.at(-1)?.push([point.longitude, point.latitude]);
    });
    return lines;
  }

  /** Between two points on the straight line between them; null: before the first one, or when there is none. */
  at(time: number): Moment | null {
    const index = this.#lastBy(time);
    const before = this.#points[index];
    if (before === undefined) {
      return null;
    }
    const after = this.#points[index + 1];
    const from = this.#times[index] as number;
    const gap = (this.#times[index + 1] ?? Infinity) - from;
    const share = after === undefined || gap > LONGEST_GAP_MILLISECONDS ? 0 : (time - from) / gap;
    return {
      latitude: between(before.latitude, after?.latitude, share),
      longitude: between(before.longitude, after?.longitude, share),
      heading: before.heading,
      altitude: partly(before.altitudeAboveHome, after?.altitudeAboveHome, share),
      speed: partly(before.groundSpeed, after?.groundSpeed, share),
      battery: before.batteryPercent,
      mode: before.mode,
    };
  }

  /** The index of the last point by then; -1: there is none. */
  #lastBy(time: number): number {
    let low = -1;
    let high = this.#times.length - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if ((this.#times[middle] as number) <= time) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }
}

function between(from: number, to: number | undefined, share: number): number {
  return to === undefined ? from : from + (to - from) * share;
}

function partly(from: number | null, to: number | null | undefined, share: number): number | null {
  return from === null ? null : between(from, to ?? undefined, share);
}
