import type { VirtualDrone, VirtualShare, VirtualState } from '../api/virtual';

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

/** So many drones may share a mission. */
export const MOST_SHARERS = 8;

/** Why so many drones cannot share a mission; null: they can. */
export function whyNotShared(upTo: number | null): string | null {
  return upTo !== null && Number.isInteger(upTo) && upTo >= 1 && upTo <= MOST_SHARERS
    ? null
    : `Drones: 1 to ${MOST_SHARERS}.`;
}

/** Such as “Share 2: flying, 1 of 4 waypoints”. */
export function shareText(share: VirtualShare, index: number): string {
  return `Share ${index + 1}: ${STATES[share.state]}, ${share.flown} of ${share.total} waypoints`;
}

/** Such as “waiting, 2 of 3” or “flying, 1 of 4 waypoints”. */
export function stateText(drone: VirtualDrone): string {
  const { run } = drone;
  if (run === null) {
    return drone.items === null ? 'no mission yet' : 'planned';
  }
  if (run.queue !== null) {
    return `${STATES.queued}, ${run.queue.position} of ${run.queue.length} in the queue`;
  }
  const state = `${STATES[run.state]}, ${run.flown} of ${run.total} waypoints`;
  return (run.shares?.length ?? 0) > 1 ? `${state}, ${dronesText(run.drones ?? 0)}` : state;
}

/** What follows of starting it. */
export function startText({ upTo }: Pick<VirtualDrone, 'upTo'>): string {
  return (upTo ?? 1) > 1
    ? `Up to ${upTo ?? 1} free drones of the pool arm and take off at once.`
    : 'A free drone of the pool arms and takes off at once.';
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

function dronesText(drones: number): string {
  return drones === 1 ? '1 drone' : `${drones} drones`;
}

/** The state of the serving drone, such as “battery 87 %, 20 m above home”; empty when none does. */
export function liveText({ live }: Pick<VirtualDrone, 'live'>): string {
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
