import { ANSWER_MILLISECONDS, type Positions, type Receipt } from '../api/follows';
import { Problem } from '../api/problem';
import type { Timers } from '@dronemap/client';
import { positionsOf, type Fix } from './fix';
import { FixBuffer } from './fix-buffer';

/** Sends positions to the cloud; rejects with a Problem when it cannot be reached, or refuses them. */
export type SendPositions = (positions: Positions) => Promise<Receipt>;

export const RETRY_MILLISECONDS = 1_000;
/** After so long without a position the cloud gets an empty message, so that it knows that the phone is there. */
export const LOST_MILLISECONDS = 2_000;

/** Sends positions of the target over an unreliable connection: one message at a time, repeated until it is accepted. */
export class PositionUplink {
  /** The time of the last message that the cloud accepted, while newer ones are not received; null: they are. */
  cutOffSince = $state<number | null>(null);
  /** The reason for which the cloud refuses positions; null: it accepts them. */
  refused = $state<string | null>(null);
  readonly buffer = new FixBuffer();
  readonly #transmit: SendPositions;
  readonly #timers: Timers;
  readonly #wall: () => number;
  #lastAccepted: number | null = null;
  #roundTrip: number | null = null;
  #lastSent = 0;
  #busy = false;
  #open = true;
  #cancelRetry: () => void = () => undefined;

  /** `wall`: the phone's own clock, by which fixes are dated. */
  constructor(transmit: SendPositions, timers: Timers, wall: () => number = Date.now) {
    this.#transmit = transmit;
    this.#timers = timers;
    this.#wall = wall;
  }

  offer(fix: Fix): void {
    if (this.#open) {
      this.buffer.add(fix);
      void this.#send();
    }
  }

  /** Sends now instead of at the planned retry: the connection seems to be back. */
  retryNow(): void {
    void this.#send();
  }

  /** Sends what waits after the page was stopped by the system. */
  resumed(): void {
    this.#lastSent = this.#timers.now();
    void this.#send();
  }

  close(): void {
    this.#open = false;
    this.#cancelRetry();
    this.buffer.clear();
  }

  /** To be called periodically: sends an empty message when none was sent for long. */
  keepAlive(): void {
    if (this.buffer.pending.length === 0 && this.#timers.now() - this.#lastSent >= LOST_MILLISECONDS) {
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
    this.#lastSent = began;
    try {
      const { upTo } = await this.#within(this.#transmit(positionsOf(fixes, this.#wall(), this.#roundTrip)));
      this.#roundTrip = Math.round(this.#timers.now() - began);
      this.#accepted(fixes.length === 0 ? 0 : upTo);
    } catch (thrown) {
      this.#failed(thrown, fixes);
    } finally {
      this.#busy = false;
    }
    if (this.cutOffSince === null) {
      void this.#send();
    }
  }

  #accepted(upTo: number | null): void {
    if (upTo === null) {
      // It was too busy for any of them.
      throw Problem.unreachable();
    }
    this.buffer.acknowledge(upTo);
    this.#lastAccepted = this.#wall();
    this.cutOffSince = null;
    this.refused = null;
  }

  #failed(thrown: unknown, fixes: readonly Fix[]): void {
    if (thrown instanceof Problem && isRefusal(thrown)) {
      // The same positions would be refused again.
      this.buffer.acknowledge(fixes.at(-1)?.at ?? 0);
      this.refused = thrown.message;
      return;
    }
    this.cutOffSince ??= this.#lastAccepted ?? this.#wall();
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
