import type { Drone } from '../api/types';
import { cannot } from '../fleet/ability';
import { placeOf } from '../fleet/place';
import type { Coordinates } from '../geo/coordinates';
import { placeAt } from '../geo/distance';
import { addWaypoint, emptyDraft, type Draft } from './draft';
import { emptyLanding } from './landing';

/** Metres above home, which a runway is about as high as. */
const CLIMB_METERS = 50;
/** Seven metres ahead for each metre down: the cloud wants six, and places are rounded. */
const APPROACH_HEIGHT_METERS = 40;
const APPROACH_METERS = 300;

/** Whether it flies on wings alone: it takes off and lands by missions, and only at a place. */
export function fliesOnWings(drone: Drone): boolean {
  return drone.kind === 'fixedWing' && !cannot(drone, 'uploadMission');
}

/**
 * A mission that lands it at home, in the direction in which the plane looks where it stands, as it is put into the wind
 * to take off; on the ground it begins with a take-off, and keeps what was drafted. Further waypoints come before the
 * approach. Null without a place.
 */
export function wingMission(drone: Drone, drafted: Draft | null): Draft | null {
  const place: Coordinates | null = drone.home ?? placeOf(drone);
  if (place === null) {
    return null;
  }
  const onGround = drone.flight !== 'inAir';
  const kept = onGround && drafted !== null ? drafted : emptyDraft();
  const begun: Draft = { ...kept, takeOff: onGround, takeOffAltitude: CLIMB_METERS };
  return kept.ending === 'land' && kept.landing?.place
    ? begun
    : landingAt(begun, place, onGround ? headingOf(drone) : 0);
}

function headingOf({ motion, attitude }: Drone): number {
  return motion?.heading ?? attitude?.yaw ?? 0;
}

function landingAt(draft: Draft, { latitude, longitude }: Coordinates, heading: number): Draft {
  const place = { latitude, longitude };
  const from = placeAt(place, heading + 180, APPROACH_METERS);
  return {
    ...addWaypoint({ ...draft, landing: null }, from, APPROACH_HEIGHT_METERS),
    ending: 'land',
    landing: { ...emptyLanding(), place, approach: draft.nextKey },
  };
}
