import type { Drone } from '../api/types';
import type { Coordinates } from '../geo/coordinates';

/** The position of a drone in its own frame, as text; null where it has none. */
export function localPlaceOf(drone: Drone): string | null {
  const { local } = drone;
  return local ? `x ${local.x.toFixed(2)} m, y ${local.y.toFixed(2)} m on its own map` : null;
}

/** The position of a drone; null while it is unknown. */
export function placeOf(drone: Drone | null): Coordinates | null {
  const { latitude = null, longitude = null } = drone?.position ?? {};
  return latitude === null || longitude === null ? null : { latitude, longitude };
}
