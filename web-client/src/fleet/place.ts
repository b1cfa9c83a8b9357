import type { Drone } from '../api/types';
import type { Coordinates } from '../geo/coordinates';

/** Where a drone is in a frame of its own, in words; null where it has none. */
export function localPlaceOf(drone: Drone): string | null {
  const { local } = drone;
  return local ? `x ${local.x.toFixed(2)} m, y ${local.y.toFixed(2)} m on its own map` : null;
}

/** Where a drone is, or null while that is not known. */
export function placeOf(drone: Drone | null): Coordinates | null {
  const { latitude = null, longitude = null } = drone?.position ?? {};
  return latitude === null || longitude === null ? null : { latitude, longitude };
}
