// @ts-check
/** Places on the earth, and on a map in Mercator's projection whose world is a square of side 1. */

/** @typedef {{ latitude: number, longitude: number }} Place */
/** @typedef {{ x: number, y: number }} Point */

const EARTH_RADIUS_METERS = 6_371_008.8;
export const EQUATOR_METERS = 40_075_016.686;
const MOST_LATITUDE = 85;
/** @param {number} degrees */
const radians = (degrees) => (degrees * Math.PI) / 180;

/** @param {Place} place @returns {Point} */
export function project({ latitude, longitude }) {
  const sine = Math.sin(radians(Math.max(-MOST_LATITUDE, Math.min(MOST_LATITUDE, latitude))));
  return { x: (longitude + 180) / 360, y: 0.5 - Math.log((1 + sine) / (1 - sine)) / (4 * Math.PI) };
}

/** @param {Point} point @returns {Place} */
export function unproject({ x, y }) {
  const latitude = (Math.atan(Math.sinh(Math.PI * (1 - 2 * y))) * 180) / Math.PI;
  return { latitude, longitude: ((((x * 360) % 360) + 360) % 360) - 180 };
}

/** @param {Place} from @param {Place} to */
export function distanceMeters(from, to) {
  const north = Math.sin(radians(to.latitude - from.latitude) / 2);
  const east = Math.sin(radians(to.longitude - from.longitude) / 2);
  const cosines = Math.cos(radians(from.latitude)) * Math.cos(radians(to.latitude));
  return 2 * EARTH_RADIUS_METERS * Math.asin(Math.sqrt(north * north + cosines * east * east));
}

/** "47.397700, 8.546396" @param {Place} place */
export function placeText({ latitude, longitude }) {
  return `${latitude.toFixed(6)}, ${longitude.toFixed(6)}`;
}

/** Two numbers in degrees, latitude first; null: it is none. @param {string} text @returns {Place | null} */
export function parsePlace(text) {
  const parts = text.trim().split(/[\s,;]+/);
  const [latitude, longitude] = parts.map(Number);
  const right = parts.length === 2 && Math.abs(Number(latitude)) <= 90 && Math.abs(Number(longitude)) <= 180;
  return right ? { latitude: Number(latitude), longitude: Number(longitude) } : null;
}
