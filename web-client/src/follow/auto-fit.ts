import type { Coordinates } from '../geo/coordinates';

/** The part of the map that is shown. */
export interface Viewport {
  shows(place: Coordinates): boolean;
  pixelOf(place: Coordinates): { x: number; y: number };
  size(): { width: number; height: number };
  zoom(): number;
}

/** Shows a distance of some metres. */
export const CLOSEST_ZOOM = 18.5;
/** The map is not fitted for so long after the user moved it. */
export const LEFT_ALONE_MILLISECONDS = 20_000;
/** Of the map's width and height: two that take up less are hard to tell apart. */
const SMALL = 1 / 4;
/** Nearer to the edge a sign is cut off, or lies below the map's buttons. */
const EDGE_PIXELS = 36;
/** Less is not worth a jump. */
const LEAST_STEP = 0.5;

/** Decides when the map has to be fitted anew, so that person and drone are in view, and not too small. */
export class AutoFit {
  #count = 0;
  #movedAt = -Infinity;

  movedByUser(now: number): void {
    this.#movedAt = now;
  }

  isDue(viewport: Viewport, places: readonly Coordinates[], now: number): boolean {
    const other = places.length !== this.#count;
    this.#count = places.length;
    if (other || now - this.#movedAt < LEFT_ALONE_MILLISECONDS) {
      return other && places.length > 0;
    }
    return (
      places.some((place) => !viewport.shows(place) || isAtTheEdge(viewport, place)) ||
      areSmall(viewport, places)
    );
  }
}

function isAtTheEdge(viewport: Viewport, place: Coordinates): boolean {
  const { x, y } = viewport.pixelOf(place);
  const { width, height } = viewport.size();
  return Math.min(x, y, width - x, height - y) < EDGE_PIXELS;
}

function areSmall(viewport: Viewport, places: readonly Coordinates[]): boolean {
  if (places.length < 2 || viewport.zoom() > CLOSEST_ZOOM - LEAST_STEP) {
    return false;
  }
  const pixels = places.map((place) => viewport.pixelOf(place));
  const { width, height } = viewport.size();
  return (
    extent(pixels.map(({ x }) => x)) < SMALL * width && extent(pixels.map(({ y }) => y)) < SMALL * height
  );
}

function extent(values: readonly number[]): number {
  return Math.max(...values) - Math.min(...values);
}
