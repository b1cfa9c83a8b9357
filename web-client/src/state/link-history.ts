import type { Drone } from '../api/types';

const STEP_MILLISECONDS = 2_000;
const KEPT_MILLISECONDS = 5 * 60_000;
/** No update for so long: what the link was like meanwhile is unknown. */
const GAP_MILLISECONDS = 15_000;

/** One look at a link: the share of messages that came, 0 to 1. */
export interface LinkSample {
  at: number;
  received: number;
  /** Nothing is known of the time between the one before and this one. */
  begins: boolean;
}

/** How much of what each drone sent came, in the last five minutes since this page was opened; one look every 2 s. */
export class LinkHistory {
  readonly #samples = new Map<string, LinkSample[]>();
  readonly #now: () => number;

  constructor(now: () => number = Date.now) {
    this.#now = now;
  }

  add(drone: Drone): void {
    const received = receivedOf(drone);
    if (received === null) {
      return;
    }
    const at = this.#now();
    const samples = this.#samples.get(drone.id) ?? [];
    this.#samples.set(drone.id, samples);
    const last = samples.at(-1);
    if (last !== undefined && at - last.at < STEP_MILLISECONDS && (received > 0 || last.received === 0)) {
      return;
    }
    samples.push({ at, received, begins: last === undefined || at - last.at > GAP_MILLISECONDS });
    while (samples[0] !== undefined && at - samples[0].at > KEPT_MILLISECONDS) {
      samples.shift();
    }
  }

  remove(id: string): void {
    this.#samples.delete(id);
  }

  /** Oldest first; another list each time. */
  of(id: string): readonly LinkSample[] {
    return [...(this.#samples.get(id) ?? [])];
  }
}

/** Of a lost link nothing comes; null: not known, as the vehicle does not number its messages. */
function receivedOf(drone: Drone): number | null {
  if (drone.link.state === 'lost') {
    return 0;
  }
  const loss = drone.link.quality?.lossShort ?? null;
  return loss === null ? null : 1 - loss;
}
