import type { StreamMessage } from '../api/types';
import type { Station } from './station.svelte';

type Shelves = Pick<Station, 'zones' | 'virtuals' | 'tours' | 'runs' | 'follows'>;

/** What people have drawn and planned, and what the cloud conducts for them. */
export function hearOfPlans(
  message: StreamMessage,
  { zones, virtuals, tours, runs, follows }: Shelves,
): void {
  switch (message.type) {
    case 'zone':
      zones.hear(message.zone);
      break;
    case 'zoneRemoved':
      zones.forget(message.id);
      break;
    case 'virtualDrone':
      virtuals.hear(message.virtualDrone);
      break;
    case 'virtualDroneRemoved':
      virtuals.forget(message.id);
      break;
    case 'plan':
      tours.hear(message.plan);
      break;
    case 'planRemoved':
      tours.forget(message.id);
      break;
    case 'run':
      runs.hear(message.run);
      break;
    case 'follow':
      follows.hear(message.follow);
      break;
    case 'followNow':
      follows.hearNow(message.id, message.now);
      break;
    default:
      break;
  }
}
