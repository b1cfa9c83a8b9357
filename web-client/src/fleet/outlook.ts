import type { Outlook } from '../api/control';
import type { Drone } from '../api/types';
import { distanceMeters } from '../geo/distance';
import type { Coordinates } from '../geo/coordinates';
import { distance, minuteOfDay, span } from '../ui/format';
import { placeOf } from './place';

/** Nearer than this it comes down where it is. */
const ELSEWHERE_METERS = 5;
/** The time left is announced to screen readers so often. */
const SPOKEN_SECONDS = 10;

/** A notice of a drone in the air that nobody has control of. */
export interface Notice {
  words: string;
  tone: 'amber' | 'red';
}

/** The place where a drone would be brought down. */
export interface Landing {
  place: Coordinates;
  /** From the position of the drone; null: unknown. */
  meters: number | null;
}

export function landingOf(drone: Drone | null): Landing | null {
  const { latitude = null, longitude = null } = drone?.outlook ?? {};
  if (!drone?.outlook || latitude === null || longitude === null) {
    return null;
  }
  const place = { latitude, longitude };
  const here = placeOf(drone);
  return { place, meters: here === null ? null : distanceMeters(here, place) };
}

/** The place where it would come down, where that is not below it. */
export function landsElsewhere(drone: Drone | null): Coordinates | null {
  const landing = landingOf(drone);
  return landing !== null && (landing.meters ?? 0) > ELSEWHERE_METERS ? landing.place : null;
}

/** "home, 320 m away"; null: nowhere that is known. */
export function landingText(drone: Drone): string | null {
  const { outlook } = drone;
  if (!outlook?.comesDown) {
    return null;
  }
  const meters = landingOf(drone)?.meters ?? 0;
  return meters > ELSEWHERE_METERS ? `${outlook.comesDown}, ${distance(meters)} away` : outlook.comesDown;
}

/** "until about 14:32 (11 min)"; null: unknown. */
export function batteryText({ emptyAt }: Outlook, now: number): string | null {
  if (emptyAt === null) {
    return null;
  }
  const minutes = Math.floor((Date.parse(emptyAt) - now) / 60_000);
  return `until about ${minuteOfDay(emptyAt)} (${minutes < 1 ? 'less than 1' : minutes} min)`;
}

/**
 * The countdown until a drone without control is brought home or down; null: somebody has control, or nothing is due. `now`:
 * the cloud's time; null: there is no connection, so that nothing can be counted down.
 */
export function countdownOf(drone: Drone, now: number | null): Notice | null {
  const { outlook } = drone;
  if (!outlook) {
    return null;
  }
  if (outlook.state === 'helpless') {
    return { words: 'No safe landing place known', tone: 'red' };
  }
  if (outlook.returnsAt === null || now === null) {
    return null;
  }
  return { words: `${returnText(outlook)} ${inSeconds(secondsTo(outlook.returnsAt, now))}`, tone: 'amber' };
}

/** The same for the ear: it changes every ten seconds. */
export function spokenCountdown(drone: Drone, now: number | null): string {
  const counted = countdownOf(drone, now);
  if (counted === null) {
    return '';
  }
  const { outlook } = drone;
  if (counted.tone === 'red' || !outlook?.returnsAt || now === null) {
    return `${counted.words}: take control of it.`;
  }
  const seconds = Math.ceil(secondsTo(outlook.returnsAt, now) / SPOKEN_SECONDS) * SPOKEN_SECONDS;
  return seconds === 0
    ? `${returnText(outlook)} now.`
    : `${returnText(outlook)} within ${span(seconds)} unless somebody takes control.`;
}

/** The notice in the list of drones; null: somebody has control. */
export function noticeOf(drone: Drone, now: number | null): Notice | null {
  const { outlook } = drone;
  const counted = countdownOf(drone, now);
  if (counted?.tone === 'red') {
    return { ...counted, words: 'No control · no safe landing' };
  }
  if (!outlook?.returnsAt) {
    return null;
  }
  const where = returnsHome(outlook) ? 'home' : 'down';
  const when = now === null ? '' : ` ${inSeconds(secondsTo(outlook.returnsAt, now))}`;
  return { words: `No control · ${where}${when}`, tone: 'amber' };
}

function returnText(outlook: Outlook): string {
  return returnsHome(outlook) ? 'Brought home' : 'Brought down';
}

/** Also one that would circle there: it comes down nowhere. */
function returnsHome({ comesDown }: Outlook): boolean {
  return comesDown === 'home' || comesDown === null;
}

function secondsTo(iso: string, now: number): number {
  return Math.max(0, Math.ceil((Date.parse(iso) - now) / 1000));
}

function inSeconds(seconds: number): string {
  return seconds === 0 ? 'now' : `in ${span(seconds)}`;
}
