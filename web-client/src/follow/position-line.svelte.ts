import { ANSWER_MILLISECONDS, type Positions, type Receipt } from '../api/follows';
import { Problem } from '../api/problem';
import type { Timers } from '../api/stream';
import { positionsOf, type Fix } from './fix';
import { FixBuffer } from './fix-buffer';

/** By which positions go up. It rejects with a Problem when the cloud cannot be reached, or does not want them. */
export type SayPositions = (positions: Positions) => Promise<Receipt>;

export const RETRY_MILLISECONDS = 1_000;
/** So long without a position, and the cloud is told that the phone is there all the same. */
export const LOST_MILLISECONDS = 2_000;

/** Says where the target is over a line that fails now and then: one message at a time, again until it is taken. */
export class PositionLine {
  /** The time of the last word that the cloud took, while the newest ones do not get through; null: they do. */
  cutOffSince = $state<number | null>(null);
  /** Why the cloud does not want them; null: it does. */
  refused = $state<string | null>(null);
  readonly buffer = new FixBuffer();
  readonly #say: SayPositions;
  readonly #timers: Timers;
  readonly #wall: () => number;
  #lastTaken: number | null = null;
  #roundTrip: number | null = null;
  #said = 0;
  #busy = false;
  #open = true;
  #cancelRetry: () => void = () => undefined;

  /** `wall`: the phone's own clock, by which fixes are dated. */
  constructor(say: SayPositions, timers: Timers, wall: () => number = Date.now) {
    this.#say = say;
    this.#timers = timers;
    this.#wall = wall;
  }

  offer(fix: Fix): void {
    if (this.#open) {
      this.buffer.add(fix);
      void this.#send();
    }
  }

  /** The line seems to be there again: does not wait for the planned try. */
  retryNow(): void {
    void this.#send();
  }

  /** The page runs again after it was stopped: what waits goes up, and the receiver has a moment to speak. */
  woke(): void {
    this.#said = this.#timers.now();
    void this.#send();
  }

  close(): void {
    this.#open = false;
    this.#cancelRetry();
    this.buffer.clear();
  }

  /** Once in a while: says that the phone is there, where it has not said so for long. */
  beat(): void {
    if (this.buffer.pending.length === 0 && this.#timers.now() - this.#said >= LOST_MILLISECONDS) {
      void this.#send(true);
    }
  }

  async #send(evenEmpty = false): Promise<void> {
    const fixes = this.buffer.pending;
    if (this.#busy || !this.#open || (fixes.length === 0 && !evenEmpty)) {
      return;
    }
    this.#cancelRetry();
    this.#busy = true;
    const began = this.#timers.now();
    this.#said = began;
    try {
      const { upTo } = await this.#within(this.#say(positionsOf(fixes, this.#wall(), this.#roundTrip)));
      this.#roundTrip = Math.round(this.#timers.now() - began);
      this.#taken(fixes.length === 0 ? 0 : upTo);
    } catch (thrown) {
      this.#failed(thrown, fixes);
    } finally {
      this.#busy = false;
    }
    if (this.cutOffSince === null) {
      void this.#send();
    }
  }

  #taken(upTo: number | null): void {
    if (upTo === null) {
      // It was too busy for any of them.
      throw Problem.unreachable();
    }
    this.buffer.settle(upTo);
    this.#lastTaken = this.#wall();
    this.cutOffSince = null;
    this.refused = null;
  }

  #failed(thrown: unknown, fixes: readonly Fix[]): void {
    if (thrown instanceof Problem && isRefusal(thrown)) {
      // The same words would be refused again.
      this.buffer.settle(fixes.at(-1)?.at ?? 0);
      this.refused = thrown.message;
      return;
    }
    this.cutOffSince ??= this.#lastTaken ?? this.#wall();
    if (this.#open) {
      this.#cancelRetry = this.#timers.after(RETRY_MILLISECONDS, () => void this.#send());
    }
  }

  #within<T>(answer: Promise<T>): Promise<T> {
    return new Promise((resolve, reject) => {
      const cancel = this.#timers.after(ANSWER_MILLISECONDS, () => reject(Problem.unreachable()));
      answer.then(resolve, reject).finally(cancel);
    });
  }
}

function isRefusal(problem: Problem): boolean {
  return problem.status >= 400 && problem.status < 500 && problem.status !== 408 && problem.status !== 429;
}
