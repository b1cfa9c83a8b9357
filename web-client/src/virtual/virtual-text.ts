import type { VirtualDrone, VirtualState } from '../api/virtual';

const STATES: Record<VirtualState, string> = {
  queued: 'waiting',
  uploading: 'bound',
  arming: 'arming',
  starting: 'starting',
  flying: 'flying',
  returning: 'returning',
  givingUp: 'changing drones',
  stopping: 'stopping',
  suspended: 'suspended',
  done: 'done',
  failed: 'failed',
  stopped: 'stopped',
};

/** Such as “waiting, 2 of 3” or “flying, 1 of 4 waypoints”. */
export function stateText(drone: VirtualDrone): string {
  const { run } = drone;
  if (run === null) {
    return drone.items === null ? 'no mission yet' : 'planned';
  }
  if (run.queue !== null) {
    return `${STATES.queued}, ${run.queue.position} of ${run.queue.length} in the queue`;
  }
  return `${STATES[run.state]}, ${run.flown} of ${run.total} waypoints`;
}

export type Tone = 'good' | 'look' | 'bad' | 'plain';

export function toneOf(drone: VirtualDrone): Tone {
  switch (drone.run?.state) {
    case 'flying':
    case 'returning':
    case 'done':
      return 'good';
    case 'suspended':
    case 'givingUp':
      return 'look';
    case 'failed':
      return 'bad';
    default:
      return 'plain';
  }
}

/** The state of the serving drone, such as “battery 87 %, 20 m above home”; empty when none does. */
export function liveText(drone: VirtualDrone): string {
  const { live } = drone;
  if (live === null) {
    return '';
  }
  const height = live.position?.altitudeAboveHome ?? null;
  const parts = [
    live.link === 'live' ? null : `contact ${live.link}`,
    live.battery === null ? null : `battery ${live.battery} %`,
    height === null ? null : `${Math.round(height)} m above home`,
  ];
  return parts.filter((part) => part !== null).join(', ');
}
