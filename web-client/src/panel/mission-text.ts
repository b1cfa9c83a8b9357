import type { Drone, MissionItem, VehicleMission } from '../api/types';
import { formatCoordinates } from '../geo/coordinates';
import { landingPlace } from '../plan/landing';
import { itemNumber } from '../plan/numbering';
import { counted, fixed } from '../ui/format';

export interface MissionRow {
  words: string;
  /** As on the map and in sentences about the mission. */
  number: number;
  state: 'reached' | 'current' | 'ahead';
}

/** The vehicle's own mission as lines to read. */
export function missionRows(mission: VehicleMission | null): MissionRow[] {
  const reached = new Set(mission?.reached ?? []);
  return (mission?.items ?? []).map((item, index) => {
    const current = mission?.running === true && mission.current === index;
    return {
      words: itemText(item),
      number: itemNumber(index),
      state: reached.has(index) ? 'reached' : current ? 'current' : 'ahead',
    };
  });
}

export function missionSummary(mission: VehicleMission | null): string {
  const total = mission?.items?.length ?? mission?.total ?? null;
  if (mission === null || total === null) {
    return 'Mission unknown.';
  }
  return total === 0 ? 'No mission on the vehicle.' : summaryOf(mission, total);
}

function summaryOf(mission: VehicleMission, total: number): string {
  const count = counted(total, 'item');
  const reached = new Set(mission.reached).size;
  if (isComplete(mission)) {
    return `Mission complete: ${count}.`;
  }
  if (mission.running) {
    const at = mission.current === null ? '' : `item ${itemNumber(mission.current)} of ${total}, `;
    return `Mission is running: ${at}${reached} reached.`;
  }
  if (mission.state === 'paused') {
    return `Mission is paused: ${reached} of ${count} reached.`;
  }
  return reached > 0
    ? `Mission is not running: ${reached} of ${count} reached.`
    : `Mission on the vehicle: ${count}.`;
}

/** The vehicle's own word where it gives one; else all items reached. */
function isComplete(mission: VehicleMission): boolean {
  const total = mission.items?.length ?? mission.total ?? 0;
  return mission.state === 'complete' || (mission.state === null && new Set(mission.reached).size >= total);
}

/**
 * Why a mission need not be started now, or null. A vehicle on the ground may call its mission running and yet wait
 * for the word to take off.
 */
export function whyNoStart(drone: Drone): string | null {
  const { mission, flight } = drone;
  return mission?.running && flight !== 'onGround' && !isComplete(mission) ? 'It is running.' : null;
}

function landText(item: MissionItem): string {
  const place = landingPlace(item);
  return place === null ? 'Land' : `Land at ${formatCoordinates(place)}`;
}

function itemText(item: MissionItem): string {
  switch (item.type) {
    case 'takeOff':
      return `Take off to ${fixed(item.altitude)} m`;
    case 'waypoint': {
      const reference = item.altitudeReference === 'amsl' ? ' above sea' : '';
      const wait = item.holdSeconds ? `, wait ${fixed(item.holdSeconds)} s` : '';
      return `Waypoint at ${fixed(item.altitude)} m${reference}${wait}`;
    }
    case 'returnToLaunch':
      return 'Return to launch';
    case 'land':
      return landText(item);
    case 'wait':
      return `Wait ${fixed(item.holdSeconds)} s`;
    case 'takePhoto':
      return 'Take a photo';
    case 'setServo':
      return `Servo ${item.output} to ${item.pulse} µs`;
    case 'lookAt':
      return `Look at ${fixed(item.latitude, 6)}, ${fixed(item.longitude, 6)}`;
    case 'lookAhead':
      return 'Look ahead';
    default:
      return item.description;
  }
}
