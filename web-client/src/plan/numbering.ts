import type { Drone, MissionItem } from '../api/types';
import { cannot } from '../fleet/ability';
import { itemsOf, TAKE_OFF_RANGE, type Draft } from './draft';

/**
 * Items are numbered from 1, the take-off included: in lists, on the map, in the cloud's sentences, and in what
 * ArduPilot says ("Reached command #3"), whose number 0 is its home.
 */
export function itemNumber(index: number): number {
  return index + 1;
}

/** Whether the mission on the vehicle will begin with a take-off: its own, or the one that the cloud puts in front. */
export function beginsWithTakeOff(draft: Draft, drone: Drone | null): boolean {
  return draft.takeOff || (drone !== null && !cannot(drone, 'takeOff'));
}

/** The number that a waypoint of a plan will have on the vehicle. */
export function waypointNumber(draft: Draft, drone: Drone | null, index: number): number {
  return itemNumber(beginsWithTakeOff(draft, drone) ? index + 1 : index);
}

/** The height of the take-off, metres above home; null when it depends on the vehicle's home. */
export function takeOffHeight(draft: Draft): number | null {
  if (draft.takeOff) {
    return draft.takeOffAltitude;
  }
  const first = draft.waypoints[0];
  return first === undefined || first.altitudeReference === 'amsl' || first.altitude === null
    ? null
    : Math.min(TAKE_OFF_RANGE.highest, Math.max(TAKE_OFF_RANGE.lowest, first.altitude));
}

/** The mission as it will be on the vehicle after the upload. */
export function itemsOnVehicle(draft: Draft, drone: Drone | null): MissionItem[] {
  const items = itemsOf(draft);
  return draft.takeOff || !beginsWithTakeOff(draft, drone)
    ? items
    : [{ type: 'takeOff', altitude: takeOffHeight(draft) ?? TAKE_OFF_RANGE.lowest }, ...items];
}
