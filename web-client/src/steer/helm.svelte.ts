import type { Velocity } from '../api/types';
import { NEUTRAL, sum, velocityOf, type Axes, type Pace } from './axes';

/** The server forgets a speed after half a second; four of five may be late. */
export const SETPOINT_MILLISECONDS = 100;

export interface HelmPort {
  /** False when there is no line to the cloud. */
  steer(velocity: Velocity): boolean;
  letGo(): void;
  every(milliseconds: number, action: () => void): () => void;
}

export const LINE_DOWN = 'The line to the cloud is down; it stands still by itself.';

/**
 * Hands on the controls of one drone. As long as one of them holds something, its speeds are said again and again; when the last
 * lets go, or the cloud says no, the drone stands. After a no nothing is said before all hands were off.
 */
export class Helm {
  /** What is said now; null: nobody steers from here. */
  saying = $state.raw<Velocity | null>(null);
  problem = $state.raw<string | null>(null);
  pace: Pace;
  readonly #port: HelmPort;
  readonly #hands = new Map<string, Axes>();
  #stopTimer: (() => void) | null = null;
  #refused = false;

  constructor(port: HelmPort, pace: Pace) {
    this.#port = port;
    this.pace = pace;
  }

  /** That hand holds this; null: it has let go. */
  hold(hand: string, axes: Axes | null): void {
    if (axes === null) {
      this.#hands.delete(hand);
    } else {
      this.#hands.set(hand, axes);
    }
    if (this.#hands.size === 0) {
      this.#end();
      this.#refused = false;
    } else if (this.#stopTimer === null && !this.#refused) {
      this.problem = null;
      this.#stopTimer = this.#port.every(SETPOINT_MILLISECONDS, () => this.#say());
      this.#say();
    }
  }

  /** All hands off: the window is left, the page hidden, or Escape pressed. They must be taken away before they count again. */
  release(): void {
    this.#refused = this.#hands.size > 0;
    this.#end();
  }

  /** Nobody holds anything any more, and nothing is remembered. */
  clear(): void {
    this.#hands.clear();
    this.#refused = false;
    this.#end();
  }

  /** The cloud takes no speeds from here, because of this. */
  refuse(why: string): void {
    this.problem = why;
    if (this.#stopTimer !== null) {
      this.release();
    }
  }

  #say(): void {
    const velocity = velocityOf(sum([NEUTRAL, ...this.#hands.values()]), this.pace);
    this.saying = velocity;
    if (!this.#port.steer(velocity)) {
      this.refuse(LINE_DOWN);
    }
  }

  #end(): void {
    if (this.#stopTimer !== null) {
      this.#stopTimer();
      this.#stopTimer = null;
      this.saying = null;
      this.#port.letGo();
    }
  }
}
