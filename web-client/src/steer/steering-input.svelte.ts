import type { Velocity } from '../api/types';
import { NEUTRAL, sum, velocityOf, type Axes, type Pace } from './axes';

/** A setpoint expires at the server after half a second; four of five may be late. */
export const SETPOINT_MILLISECONDS = 100;

export interface SteeringPort {
  /** False without a connection to the cloud. */
  steer(velocity: Velocity): boolean;
  letGo(): void;
  every(milliseconds: number, action: () => void): () => void;
}

export const LINK_DOWN = 'No connection to the cloud; it stops by itself.';

/**
 * The steering input of one drone, from keys and sticks. While one of them is held, velocity setpoints are sent periodically; when
 * the last is released, or the cloud refuses, the drone stops. After a refusal all must be released before any counts again.
 */
export class SteeringInput {
  /** The setpoint that is sent now; null: this page does not steer. */
  velocity = $state.raw<Velocity | null>(null);
  problem = $state.raw<string | null>(null);
  pace: Pace;
  readonly #port: SteeringPort;
  readonly #inputs = new Map<string, Axes>();
  #stopTimer: (() => void) | null = null;
  #refused = false;

  constructor(port: SteeringPort, pace: Pace) {
    this.#port = port;
    this.pace = pace;
  }

  /** Sets the axes of a source; null: it was released. */
  hold(source: string, axes: Axes | null): void {
    if (axes === null) {
      this.#inputs.delete(source);
    } else {
      this.#inputs.set(source, axes);
    }
    if (this.#inputs.size === 0) {
      this.#end();
      this.#refused = false;
    } else if (this.#stopTimer === null && !this.#refused) {
      this.problem = null;
      this.#stopTimer = this.#port.every(SETPOINT_MILLISECONDS, () => this.#send());
      this.#send();
    }
  }

  /** Stops: the window is left, the page hidden, or Escape pressed. What is still held counts again only after it was released. */
  release(): void {
    this.#refused = this.#inputs.size > 0;
    this.#end();
  }

  /** Stops and forgets all sources. */
  clear(): void {
    this.#inputs.clear();
    this.#refused = false;
    this.#end();
  }

  /** The cloud refuses setpoints of this page, because of this. */
  refuse(why: string): void {
    this.problem = why;
    if (this.#stopTimer !== null) {
      this.release();
    }
  }

  #send(): void {
    const velocity = velocityOf(sum([NEUTRAL, ...this.#inputs.values()]), this.pace);
    this.velocity = velocity;
    if (!this.#port.steer(velocity)) {
      this.refuse(LINK_DOWN);
    }
  }

  #end(): void {
    if (this.#stopTimer !== null) {
      this.#stopTimer();
      this.#stopTimer = null;
      this.velocity = null;
      this.#port.letGo();
    }
  }
}
