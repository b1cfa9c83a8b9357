import type { Coordinates } from './coordinates';

const EARTH_RADIUS_METERS = 6_371_008.8;
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** Great-circle distance in metres. */
export function distanceMeters(from: Coordinates, to: Coordinates): number {
  const north = radians(to.latitude - from.latitude);
  const east = radians(to.longitude - from.longitude);
  const chord =
    Math.sin(north / 2) ** 2 +
    Math.cos(radians(from.latitude)) * Math.cos(radians(to.latitude)) * Math.sin(east / 2) ** 2;
  return 2 * EARTH_RADIUS_METERS * Math.asin(Math.min(1, Math.sqrt(chord)));
}

/** Length of a way along its points, in metres. */
export function wayLengthMeters(points: readonly Coordinates[]): number {
  let length = 0;
  for (let i = 1; i < points.length; i++) {
    length += distanceMeters(points[i - 1] as Coordinates, points[i] as Coordinates);
  }
  return length;
}
