import type { Control, ControlCalls } from '../api/control';
import { Problem } from '../api/problem';
import { PURPOSES } from '../api/purposes';
import type { CommandKind, Drone } from '../api/types';

/** The server misses three of these before it calls a holder lost. */
export const HEARTBEAT_MILLISECONDS = 2000;

/** How control of a drone looks from here. `here`: kept by this window; `elsewhere`: by another one of mine. */
export type Standing = 'free' | 'here' | 'implicit' | 'elsewhere' | 'other' | 'pilot';

type Port = Pick<ControlCalls, 'take' | 'takeOver' | 'heartbeat' | 'release' | 'handOver' | 'grant'>;

/** The drones whose control this window keeps, by heartbeats, until it gives it back, loses it or is closed. */
export class Controls {
  /** The epoch of each drone that this window keeps. */
  kept = $state.raw<ReadonlyMap<string, number>>(new Map());
  readonly #port: Port;
  readonly #now: () => number;
  #lastBeat = 0;

  constructor(port: Port, now: () => number = () => performance.now()) {
    this.#port = port;
    this.#now = now;
  }

  standing(drone: Drone, user: string | undefined): Standing {
    const control = drone.control;
    if (control.state === 'free') {
      return 'free';
    }
    if (control.state === 'pilot') {
      return 'pilot';
    }
    if (control.holder !== user) {
      return 'other';
    }
    if (!control.explicit) {
      return 'implicit';
    }
    return this.kept.get(drone.id) === control.epoch ? 'here' : 'elsewhere';
  }

  /** Why this user cannot give that command now, or null. */
  whyNot(drone: Drone, type: CommandKind, user: string | undefined, supervisor: boolean): string | null {
    const standing = this.standing(drone, user);
    const purpose = PURPOSES[type];
    if (purpose === 'read' || (supervisor && (purpose === 'safety' || purpose === 'pause'))) {
      return null;
    }
    if (standing === 'pilot') {
      return 'A pilot at the vehicle or another ground station has control; take control to command it.';
    }
    return standing === 'other' ? `${drone.control.holder ?? 'Somebody else'} has control.` : null;
  }

  async take(drone: string): Promise<void> {
    this.#keep(drone, await this.#port.take(drone));
  }

  async takeOver(drone: string, reason: string): Promise<void> {
    this.#keep(drone, await this.#port.takeOver(drone, reason));
  }

  async release(drone: string): Promise<void> {
    await this.#port.release(drone);
    this.#drop(drone);
  }

  async handOver(drone: string, user: string): Promise<void> {
    await this.#port.handOver(drone, user);
    this.#drop(drone);
  }

  async grant(drone: string, user: string): Promise<void> {
    await this.#port.grant(drone, user);
    this.#drop(drone);
  }

  clear(): void {
    this.kept = new Map();
  }

  /**
   * Sends the heartbeats when they are due. Called by a timer and by each message of the stream: browsers slow the
   * timers of windows that nobody looks at.
   */
  beat(): void {
    const now = this.#now();
    if (this.kept.size === 0 || now - this.#lastBeat < HEARTBEAT_MILLISECONDS) {
      return;
    }
    this.#lastBeat = now;
    for (const [drone, epoch] of this.kept) {
      void this.#heartbeat(drone, epoch);
    }
  }

  async #heartbeat(drone: string, epoch: number): Promise<void> {
    try {
      const control = await this.#port.heartbeat(drone, epoch);
      if (this.kept.get(drone) === epoch && control.epoch !== epoch) {
        // The server was started anew and knows it by another one.
        this.#keep(drone, control);
      }
    } catch (thrown) {
      // Without an answer it goes on: the line may come back in time.
      if (thrown instanceof Problem && thrown.status >= 400 && thrown.status < 500) {
        this.#dropIf(drone, epoch);
      }
    }
  }

  #keep(drone: string, control: Control): void {
    this.kept = new Map(this.kept).set(drone, control.epoch);
  }

  #dropIf(drone: string, epoch: number): void {
    if (this.kept.get(drone) === epoch) {
      this.#drop(drone);
    }
  }

  #drop(drone: string): void {
    const kept = new Map(this.kept);
    kept.delete(drone);
    this.kept = kept;
  }
}
