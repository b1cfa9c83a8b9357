import type { Follow, FollowStage } from '../api/follows';

/** Milliseconds on, off, on …; told apart in a pocket: short for good news, long for what wants a look. */
const PATTERNS: Record<FollowStage, readonly number[]> = {
  allocated: [60],
  starting: [60, 60, 60],
  tracking: [120, 80, 120],
  paused: [300],
  suspended: [500, 150, 500],
  returning: [200, 100, 200, 100, 200],
  over: [600],
};
export const ALARM: readonly number[] = [400, 150, 400, 150, 400];

export type Vibrate = (pattern: number[]) => unknown;

/** Vibrates the phone once for each new stage and drone, and for each new red warning. */
export class Vibration {
  readonly #vibrate: Vibrate;
  #stage: FollowStage | null = null;
  #drone: string | null = null;
  #alarms: ReadonlySet<string> = new Set();

  constructor(vibrate: Vibrate = vibratePhone) {
    this.#vibrate = vibrate;
  }

  update(follow: Pick<Follow, 'state' | 'drone'> | null, alarms: readonly string[]): void {
    const isNew = alarms.some((key) => !this.#alarms.has(key));
    this.#alarms = new Set(alarms);
    const stage = follow?.state ?? null;
    const drone = follow?.drone ?? null;
    const changed = stage !== this.#stage || drone !== this.#drone;
    this.#stage = stage;
    this.#drone = drone;
    if (isNew) {
      this.#vibrate([...ALARM]);
    } else if (changed && stage !== null) {
      this.#vibrate([...PATTERNS[stage]]);
    }
  }
}

/** Phones without a motor, and Safari, have no such thing. */
function vibratePhone(pattern: number[]): void {
  (navigator as { vibrate?: Vibrate }).vibrate?.(pattern);
}
