import type { Timers } from './stream/stream-client.js';

/** Resolves after that many milliseconds; rejects with the reason of the signal when that ends it. */
export function pause(timers: Timers, milliseconds: number, signal?: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    if (signal?.aborted === true) {
      reject(signal.reason as Error);
      return;
    }
    const stopped = (): void => {
      cancel();
      reject(signal?.reason as Error);
    };
    const cancel = timers.after(milliseconds, () => {
      signal?.removeEventListener('abort', stopped);
      resolve();
    });
    signal?.addEventListener('abort', stopped, { once: true });
  });
}

/** A signal that ends with another one, or with what is thrown when the time is over; to be ended after use. */
export class Deadline {
  readonly #controller = new AbortController();
  readonly #cancel: () => void;
  readonly #outer: AbortSignal | undefined;
  readonly #forward = (): void => this.#controller.abort(this.#outer?.reason);

  constructor(timers: Timers, milliseconds: number | undefined, reason: () => Error, outer?: AbortSignal) {
    this.#outer = outer;
    this.#cancel =
      milliseconds === undefined
        ? () => undefined
        : timers.after(milliseconds, () => this.#controller.abort(reason()));
    if (outer?.aborted === true) {
      this.#forward();
    }
    outer?.addEventListener('abort', this.#forward, { once: true });
  }

  get signal(): AbortSignal {
    return this.#controller.signal;
  }

  end(): void {
    this.#cancel();
    this.#outer?.removeEventListener('abort', this.#forward);
  }
}
