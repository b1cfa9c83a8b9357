import type { Follow, FollowPlace, PlaceChange } from '../api/follows';
import type { Drone } from '../api/types';
import { moved } from './fix';
import type { Coordinates } from '../geo/coordinates';

/** As the cloud would choose. */
export const USUAL_PLACE: FollowPlace = {
  side: 'behind',
  bearing: null,
  turn: null,
  distance: 8,
  height: 15,
};
/** Nearer, and it hangs above one's head when the phone errs. */
export const LEAST_DISTANCE = 3;
export const MOST_DISTANCE = 60;
export const LEAST_HEIGHT = 5;
export const MOST_HEIGHT = 120;
export const USUAL_TURN = 10;

/** The name by which a follow of the demo walk is recognised after a reload. */
export const DEMO_NAME = 'Demo walk';
const DEMO_NORTH_METERS = 20;
const KEY = 'dronemap.follow';

/** The request that changes the position of the drone. */
export function placeChange({ side, bearing, turn, distance, height }: FollowPlace): PlaceChange {
  return {
    side,
    distance,
    height,
    ...(side === 'fixed' ? { bearing: bearing ?? 0 } : {}),
    ...(side === 'orbit' ? { turn: turn ?? USUAL_TURN } : {}),
  };
}

/** Drones that can follow, as far as this page knows; the cloud decides. */
export function availableDrones(drones: readonly Drone[]): Drone[] {
  return drones.filter(
    (drone) =>
      !drone.replay && drone.link.state === 'live' && drone.kind === 'multicopter' && drone.home !== null,
  );
}

/** The demo walk begins beside the home of the drone that is wanted, or of one that stands ready. */
export function demoBegin(drones: readonly Drone[], wanted: string | null): Coordinates | null {
  const possible = availableDrones(drones);
  const drone = possible.find(({ id }) => id === wanted) ?? possible.find(({ armed }) => armed === false);
  return drone?.home ? moved(drone.home, 0, DEMO_NORTH_METERS) : null;
}

/** Mine and under way; the newest. */
export function mine(follows: readonly Follow[], me: string | undefined): Follow | null {
  return follows.find((follow) => follow.owner === me && follow.state !== 'over') ?? null;
}

/** Only the browser that asked goes on by itself: another one is somewhere else. */
export function remember(id: string | null): void {
  try {
    if (id === null) {
      localStorage.removeItem(KEY);
    } else {
      localStorage.setItem(KEY, id);
    }
  } catch {
    console.info('This browser keeps nothing for this page: after a reload it asks whose phone it is.');
  }
}

export function isRemembered(id: string): boolean {
  return rememberedId() === id;
}

/** The follow that this browser asked for last, as far as it keeps anything. */
export function rememberedId(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
