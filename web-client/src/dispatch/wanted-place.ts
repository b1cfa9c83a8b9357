import { mayAct } from '../api/accounts';
import type { Coordinates } from '../geo/coordinates';
import type { Station } from '../state/station.svelte';

type Part = Pick<Station, 'dispatches' | 'session' | 'view'>;

/** Marks a place where a drone is wanted; answers whether this user may send one. */
export function markWanted({ dispatches, session, view }: Part, place: Coordinates): boolean {
  if (!mayAct(session?.role, 'operator')) {
    return false;
  }
  dispatches.setPlace(place);
  // On the phone the card beside the place needs the map's room.
  view.sheet = 'low';
  return true;
}

/** The place where a drone is wanted, is to go, or was sent. */
export function wantedPlace({ dispatches, session, view }: Part): Coordinates | null {
  return dispatches.place ?? view.target ?? dispatches.underWay(session?.name)[0] ?? null;
}
