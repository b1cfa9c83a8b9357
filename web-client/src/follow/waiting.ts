import type { Follow } from '../api/follows';
import { span } from '../ui/format';
import { cutOffTitle } from './warnings';

/** The drone stands when it has heard no position for so long. */
export const HOLDS_AFTER_SECONDS = 2;
/** Whoever watches is told then: one may be late. */
export const TOLD_AFTER_SECONDS = 4;

export interface Meanwhile {
  words: string;
  /** Seconds until the drone flies home if no position comes; null: nothing counts down. */
  homeIn: number | null;
}

/** What the drone does while the phone has said nothing for so many seconds, going by how it stood when last heard of. */
export function meanwhile({ state, droneName, note, patience }: Follow, silentSeconds: number): Meanwhile {
  switch (state) {
    case 'allocated':
      return still(`${droneName} stays on the ground.`);
    case 'starting':
      return still(`${droneName} takes off and waits there. It flies home ${patience} s after that.`);
    case 'tracking':
      return silentSeconds < patience
        ? { words: `${droneName} stands still in the air and waits.`, homeIn: patience - silentSeconds }
        : still(`${droneName} has waited long enough: by now it flies home and lands there.`);
    case 'paused':
      return still(`${droneName} stays where it is, in the air.`);
    case 'suspended':
      return still(note ?? `Whoever has ${droneName} keeps it.`);
    case 'returning':
      return still(`${droneName} goes on flying home and lands there.`);
    case 'over':
      return still(`${droneName} is free again.`);
  }
}

/** Who has a network and hears nothing of the cloud cannot know what the drone does: a drone misses a cloud that is down. */
export function eitherOr(follow: Follow, silentSeconds: number): [way: string, cloud: string] | null {
  if (!['starting', 'tracking', 'paused'].includes(follow.state)) {
    return null;
  }
  const { words, homeIn } = meanwhile(follow, silentSeconds);
  return [
    `If only the way to this phone is cut, ${words}${homeIn === null ? '' : ` It flies home in ${span(homeIn)}.`}`,
    'If the cloud is down, it flies home by itself after some seconds. There is nothing to do but to watch it.',
  ];
}

/** The same in a line. */
export function cutOffLine(follow: Follow, silentSeconds: number, online: boolean): string {
  const { homeIn } = meanwhile(follow, silentSeconds);
  const home = online || homeIn === null ? '' : ` ${follow.droneName} flies home in ${span(homeIn)}.`;
  return `${cutOffTitle(online)}.${home}`;
}

function still(words: string): Meanwhile {
  return { words, homeIn: null };
}

/** By the cloud's clock: for how long a drone that shall follow has had no position; null: it has, or nobody knows. */
export function silentSeconds({ state, since, now }: Follow, cloudNow: number): number | null {
  const heard = now?.phone?.heard;
  if (state !== 'tracking' || heard === undefined) {
    return null;
  }
  const from = Math.max(Date.parse(heard), Date.parse(since));
  const seconds = Math.floor((cloudNow - from) / 1000);
  const unreached = now?.reach !== null && now?.reach !== 'speaks';
  return seconds >= TOLD_AFTER_SECONDS || (unreached && seconds >= HOLDS_AFTER_SECONDS) ? seconds : null;
}
