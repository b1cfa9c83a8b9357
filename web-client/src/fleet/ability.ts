import type { CommandKind, Drone } from '../api/types';

/** Whether its kind of vehicle has no such order at all, in whatever state it is. */
export function cannot(drone: Drone, type: CommandKind): boolean {
  const action = drone.actions[type];
  return action === undefined || action.code === 'capability-missing';
}
