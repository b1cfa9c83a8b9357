import type { StreamMessage } from '../api/types';
import type { Station } from './station.svelte';

type Stores = Pick<
  Station,
  'zones' | 'virtuals' | 'tours' | 'runs' | 'follows' | 'dispatches' | 'recoveries'
>;

/** Applies a message about zones, plans or operations to the store that holds them. */
export function applyUpdate(message: StreamMessage, stores: Stores): void {
  const { zones, virtuals, tours, runs, follows, dispatches, recoveries } = stores;
  switch (message.type) {
    case 'zone':
      zones.apply(message.zone);
      break;
    case 'zoneRemoved':
      zones.applyRemoval(message.id);
      break;
    case 'virtualDrone':
      virtuals.apply(message.virtualDrone);
      break;
    case 'virtualDroneRemoved':
      virtuals.applyRemoval(message.id);
      break;
    case 'plan':
      tours.apply(message.plan);
      break;
    case 'planRemoved':
      tours.applyRemoval(message.id);
      break;
    case 'run':
      runs.apply(message.run);
      break;
    case 'follow':
      follows.apply(message.follow);
      break;
    case 'followNow':
      follows.applyNow(message.id, message.now);
      break;
    case 'dispatch':
      dispatches.apply(message.dispatch);
      break;
    case 'dispatchNow':
      dispatches.applyNow(message.id, message.now);
      break;
    default:
      applyRecovery(message, recoveries);
      break;
  }
}

function applyRecovery(message: StreamMessage, recoveries: Stores['recoveries']): void {
  if (message.type === 'recovery') {
    recoveries.apply(message.recovery);
  }
}
