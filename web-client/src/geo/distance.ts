import type { Coordinates } from './coordinates';

const EARTH_RADIUS_METERS = 6_371_008.8;
const radians = (degrees: number): number => (degrees * Math.PI) / 180;
const degrees = (radian: number): number => (radian * 180) / Math.PI;

/** Great-circle distance in metres. */
export function distanceMeters(from: Coordinates, to: Coordinates): number {
  const north = radians(to.latitude - from.latitude);
  const east = radians(to.longitude - from.longitude);
  const chord =
    Math.sin(north / 2) ** 2 +
    Math.cos(radians(from.latitude)) * Math.cos(radians(to.latitude)) * Math.sin(east / 2) ** 2;
  return 2 * EARTH_RADIUS_METERS * Math.asin(Math.min(1, Math.sqrt(chord)));
}

/** The place so many metres away, in that direction: degrees clockwise from north. */
export function placeAt(from: Coordinates, bearing: number, meters: number): Coordinates {
  const angle = meters / EARTH_RADIUS_METERS;
  const latitude = radians(from.latitude);
  const towards = radians(bearing);
  const north = Math.asin(
    Math.sin(latitude) * Math.cos(angle) + Math.cos(latitude) * Math.sin(angle) * Math.cos(towards),
  );
  const east = Math.atan2(
    Math.sin(towards) * Math.sin(angle) * Math.cos(latitude),
    Math.cos(angle) - Math.sin(latitude) * Math.sin(north),
  );
  const longitude = from.longitude + degrees(east);
  return { latitude: degrees(north), longitude: ((longitude + 540) % 360) - 180 };
}

/** Length of a way along its points, in metres. */
export function wayLengthMeters(points: readonly Coordinates[]): number {
  let length = 0;
  for (let i = 1; i < points.length; i++) {
    length += distanceMeters(points[i - 1] as Coordinates, points[i] as Coordinates);
  }
  return length;
}
