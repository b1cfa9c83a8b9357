import type { Coordinates } from '../geo/coordinates';

/** What a map shows just now. */
export interface Sight {
  shows(place: Coordinates): boolean;
  pixelOf(place: Coordinates): { x: number; y: number };
  size(): { width: number; height: number };
  zoom(): number;
}

/** Shows a distance of some metres. */
export const CLOSEST_ZOOM = 18.5;
/** So long a map stays as somebody moved it. */
export const LEFT_ALONE_MILLISECONDS = 20_000;
/** Of the map's width and height: two that take up less are hard to tell apart. */
const SMALL = 1 / 4;
/** Nearer to the edge a sign is cut off, or lies below the map's buttons. */
const EDGE_PIXELS = 36;
/** Less is not worth a jump. */
const LEAST_STEP = 0.5;

/** Says when a map has to be fitted anew, so that person and drone are in sight, and not too small. */
export class InSight {
  #count = 0;
  #movedAt = -Infinity;

  movedByHand(now: number): void {
    this.#movedAt = now;
  }

  isDue(sight: Sight, places: readonly Coordinates[], now: number): boolean {
    const other = places.length !== this.#count;
    this.#count = places.length;
    if (other || now - this.#movedAt < LEFT_ALONE_MILLISECONDS) {
      return other && places.length > 0;
    }
    return (
      places.some((place) => !sight.shows(place) || isAtTheEdge(sight, place)) || areSmall(sight, places)
    );
  }
}

function isAtTheEdge(sight: Sight, place: Coordinates): boolean {
  const { x, y } = sight.pixelOf(place);
  const { width, height } = sight.size();
  return Math.min(x, y, width - x, height - y) < EDGE_PIXELS;
}

function areSmall(sight: Sight, places: readonly Coordinates[]): boolean {
  if (places.length < 2 || sight.zoom() > CLOSEST_ZOOM - LEAST_STEP) {
    return false;
  }
  const pixels = places.map((place) => sight.pixelOf(place));
  const { width, height } = sight.size();
  return (
    extent(pixels.map(({ x }) => x)) < SMALL * width && extent(pixels.map(({ y }) => y)) < SMALL * height
  );
}

function extent(values: readonly number[]): number {
  return Math.max(...values) - Math.min(...values);
}
