import type { Timers } from '../stream/stream-client.js';
import { pause } from '../timing.js';
import { Problem } from './problem.js';

const FIRST_MILLISECONDS = 500;
const LONGEST_MILLISECONDS = 5_000;

/** Pauses between tries of the same request: as long as the server says, else growing. */
export class Patience {
  readonly #timers: Timers;
  #next = FIRST_MILLISECONDS;

  constructor(timers: Timers) {
    this.#timers = timers;
  }

  /** Milliseconds until the next try after that problem. */
  afterProblem({ retryAfterSeconds }: Problem): number {
    const own = this.#next;
    this.#next = Math.min(LONGEST_MILLISECONDS, own * 2);
    return retryAfterSeconds === null ? own : retryAfterSeconds * 1000;
  }

  async wait(milliseconds: number, signal: AbortSignal | undefined): Promise<void> {
    await pause(this.#timers, milliseconds, signal);
  }

  /** It went well: the next problem is the first again. */
  reset(): void {
    this.#next = FIRST_MILLISECONDS;
  }
}

/** Tries for so many milliseconds while the server cannot be reached or is busy; then rejects with the last problem. */
export async function persistently<T>(
  timers: Timers,
  timeout: number,
  signal: AbortSignal | undefined,
  attempt: () => Promise<T>,
): Promise<T> {
  const end = timers.now() + timeout;
  const patience = new Patience(timers);
  for (;;) {
    try {
      return await attempt();
    } catch (thrown) {
      if (!(thrown instanceof Problem && thrown.mayPass)) {
        throw thrown;
      }
      const wait = patience.afterProblem(thrown);
      if (timers.now() + wait > end) {
        throw thrown;
      }
      await patience.wait(wait, signal);
    }
  }
}
