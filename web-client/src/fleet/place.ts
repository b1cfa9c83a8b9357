import type { Drone } from '../api/types';
import type { Coordinates } from '../geo/coordinates';

/** Where a drone is, or null while that is not known. */
export function placeOf(drone: Drone | null): Coordinates | null {
  const { latitude = null, longitude = null } = drone?.position ?? {};
  return latitude === null || longitude === null ? null : { latitude, longitude };
}
