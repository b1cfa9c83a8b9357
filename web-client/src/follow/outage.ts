import type { Follow } from '../api/follows';
import { span } from '../ui/format';
import { cutOffTitle } from './warnings';

/** The drone stops after so long without a position. */
export const HOLDS_AFTER_SECONDS = 2;
/** A warning is shown after so long, since one position may be late. */
export const WARN_AFTER_SECONDS = 4;

export interface OutageState {
  words: string;
  /** Seconds until the drone flies home if no position comes; null: nothing counts down. */
  homeIn: number | null;
}

/** The behaviour of the drone after so many seconds without a message of the phone, from its last known state. */
export function outageState(
  { state, droneName, note, patience }: Follow,
  silentSeconds: number,
): OutageState {
  switch (state) {
    case 'allocated':
      return withoutCountdown(`${droneName} stays on the ground.`);
    case 'starting':
      return withoutCountdown(
        `${droneName} takes off and waits there. It flies home ${patience} s after that.`,
      );
    case 'tracking':
      return silentSeconds < patience
        ? { words: `${droneName} stands still in the air and waits.`, homeIn: patience - silentSeconds }
        : withoutCountdown(`${droneName} has waited long enough: by now it flies home and lands there.`);
    case 'paused':
      return withoutCountdown(`${droneName} stays where it is, in the air.`);
    case 'suspended':
      return withoutCountdown(note ?? `Whoever has ${droneName} keeps it.`);
    case 'returning':
      return withoutCountdown(`${droneName} goes on flying home and lands there.`);
    case 'over':
      return withoutCountdown(`${droneName} is free again.`);
  }
}

/** Both cases when the phone has a network and the cloud does not answer: a drone returns when the cloud is down. */
export function outageAlternatives(
  follow: Follow,
  silentSeconds: number,
): [way: string, cloud: string] | null {
  if (!['starting', 'tracking', 'paused'].includes(follow.state)) {
    return null;
  }
  const { words, homeIn } = outageState(follow, silentSeconds);
  return [
    `If only the way to this phone is cut, ${words}${homeIn === null ? '' : ` It flies home in ${span(homeIn)}.`}`,
    'If the cloud is down, it flies home by itself after some seconds. There is nothing to do but to watch it.',
  ];
}

/** The same in one line. */
export function cutOffSummary(follow: Follow, silentSeconds: number, online: boolean): string {
  const { homeIn } = outageState(follow, silentSeconds);
  const home = online || homeIn === null ? '' : ` ${follow.droneName} flies home in ${span(homeIn)}.`;
  return `${cutOffTitle(online)}.${home}`;
}

function withoutCountdown(words: string): OutageState {
  return { words, homeIn: null };
}

/** By the cloud's clock: for how long a drone that shall follow has had no position; null: it has, or nobody knows. */
export function silentSeconds({ state, since, now }: Follow, cloudNow: number): number | null {
  const receivedAt = now?.phone?.heard;
  if (state !== 'tracking' || receivedAt === undefined) {
    return null;
  }
  const from = Math.max(Date.parse(receivedAt), Date.parse(since));
  const seconds = Math.floor((cloudNow - from) / 1000);
  const unreached = now?.reach !== null && now?.reach !== 'speaks';
  return seconds >= WARN_AFTER_SECONDS || (unreached && seconds >= HOLDS_AFTER_SECONDS) ? seconds : null;
}
