import type { Drone, DroneKind, LinkState } from '../api/types';
import { age } from '../ui/format';

type StatePart = NonNullable<Drone['link']['outdated']>[number]['part'];

export type Tone = 'neutral' | 'green' | 'amber' | 'red';

/** The status of a drone in one word, and the colour that means it. */
export interface DroneStatus {
  word: string;
  tone: Tone;
}

export function statusOf(drone: Drone): DroneStatus {
  if (drone.link.state === 'ended') {
    return { word: 'Replay ended', tone: 'neutral' };
  }
  if (drone.link.state === 'lost') {
    // A silent vehicle that was armed may still be flying: that needs somebody, the other does not.
    return { word: 'Lost', tone: drone.armed && !drone.replay ? 'red' : 'neutral' };
  }
  if (drone.link.state === 'suspect') {
    return { word: 'Silent', tone: 'amber' };
  }
  switch (drone.flight) {
    case 'takingOff':
      return { word: 'Taking off', tone: 'green' };
    case 'inAir':
      return { word: 'Flying', tone: 'green' };
    case 'landing':
      return { word: 'Landing', tone: 'green' };
    default:
      return groundStatus(drone);
  }
}

function groundStatus(drone: Drone): DroneStatus {
  if (drone.armed) {
    return { word: 'Armed', tone: 'amber' };
  }
  if (drone.armed === null) {
    return { word: 'Unknown', tone: 'neutral' };
  }
  return { word: drone.flight === 'onGround' ? 'On ground' : 'Disarmed', tone: 'neutral' };
}

const KIND_NAMES: Record<DroneKind, string> = {
  multicopter: 'Multicopter',
  helicopter: 'Helicopter',
  fixedWing: 'Fixed wing',
  vtol: 'VTOL',
  rover: 'Rover',
  boat: 'Boat',
  submarine: 'Submarine',
  airship: 'Airship',
  unknown: 'Unknown kind',
};

export function kindName(kind: DroneKind): string {
  return KIND_NAMES[kind];
}

export function armedText(drone: Drone): string {
  if (drone.armed === null) {
    return 'Arming state unknown';
  }
  return drone.armed ? 'Armed' : 'Disarmed';
}

const LINK_WORDS: Record<LinkState, string> = {
  live: 'Live',
  suspect: 'Suspect',
  lost: 'Lost',
  ended: 'Ended',
};

/** `cut`: this page has no connection to the cloud, so that the state of the cloud's link to the drone is unknown. */
export function linkStateText(state: LinkState, cut = false): string {
  return cut && state !== 'ended' ? 'Offline' : LINK_WORDS[state];
}

/** The same in the list, where a link that is heard but gets worse than it usually is shows at a glance. */
export function linkMark({ state, trend }: Drone['link'], cut = false): { words: string; tone: Tone } {
  if (!cut && state === 'live' && trend?.state === 'falling') {
    return { words: 'Link falling', tone: 'red' };
  }
  return !cut && state === 'live' && trend?.state === 'worse'
    ? { words: 'Link worse', tone: 'amber' }
    : { words: linkStateText(state, cut), tone: 'neutral' };
}

const PART_WORDS: Record<StatePart, string> = {
  mode: 'mode',
  armed: 'armed or not',
  readiness: 'readiness',
  flight: 'in the air or not',
  position: 'position',
  local: 'local position',
  motion: 'speed',
  attitude: 'attitude',
  battery: 'battery',
  gps: 'satellites',
};

/** What a drone has stopped telling though it is heard, and for how long; null when it tells all. */
export function outdatedText(drone: Drone, since: (time: string) => number | null): string | null {
  const parts = (drone.link.outdated ?? []).map(
    ({ part, lastHeard }) => `${PART_WORDS[part]} (${age(since(lastHeard))})`,
  );
  return parts.length === 0 ? null : `Old values: ${parts.join(', ')}`;
}

/** The session key of a vehicle as people write it: address, port and system id. */
export function addressOf(drone: Drone): string {
  return `${drone.link.address}:${drone.link.port}:${drone.link.systemId}`;
}

export function batteryTone(percent: number | null | undefined): Tone {
  if (percent === null || percent === undefined || percent >= 30) {
    return 'neutral';
  }
  return percent >= 15 ? 'amber' : 'red';
}

/** True when the words the person typed all occur in what identifies the drone. */
export function matches(drone: Drone, query: string): boolean {
  const text = [drone.name, addressOf(drone), kindName(drone.kind), drone.vehicle, drone.mode, drone.place]
    .join(' ')
    .toLowerCase();
  return query
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}
