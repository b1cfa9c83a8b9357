import type { Control, ControlCalls } from '../api/control';
import { Problem } from '../api/problem';
import { PURPOSES } from '@dronemap/client';
import type { CommandKind, Drone } from '../api/types';

/** The server misses three of these before it calls a holder lost. */
export const HEARTBEAT_MILLISECONDS = 2000;

/** The lease on a drone as this window sees it. `here`: held by this window; `elsewhere`: by another one of the user. */
export type LeaseState = 'free' | 'here' | 'implicit' | 'elsewhere' | 'other' | 'pilot';

type Port = Pick<ControlCalls, 'take' | 'takeOver' | 'heartbeat' | 'release' | 'handOver' | 'grant'>;

/** The leases on drones that this window holds by heartbeats, until they are released, lost, or the window is closed. */
export class ControlLeases {
  /** The epoch of each held lease, by drone. */
  held = $state.raw<ReadonlyMap<string, number>>(new Map());
  readonly #port: Port;
  readonly #now: () => number;
  #lastHeartbeat = 0;

  constructor(port: Port, now: () => number = () => performance.now()) {
    this.#port = port;
    this.#now = now;
  }

  leaseState(drone: Drone, user: string | undefined): LeaseState {
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
    return this.held.get(drone.id) === control.epoch ? 'here' : 'elsewhere';
  }

  /** Why this user cannot give that command now, or null. */
  whyNot(drone: Drone, type: CommandKind, user: string | undefined, supervisor: boolean): string | null {
    const leaseState = this.leaseState(drone, user);
    const purpose = PURPOSES[type];
    if (purpose === 'read' || (supervisor && (purpose === 'safety' || purpose === 'pause'))) {
      return null;
    }
    if (leaseState === 'pilot') {
      return 'A pilot at the vehicle or another ground station has control; take control to command it.';
    }
    return leaseState === 'other' ? `${drone.control.holder ?? 'Somebody else'} has control.` : null;
  }

  async take(drone: string): Promise<void> {
    this.#hold(drone, await this.#port.take(drone));
  }

  async takeOver(drone: string, reason: string): Promise<void> {
    this.#hold(drone, await this.#port.takeOver(drone, reason));
  }

  async release(drone: string): Promise<void> {
    await this.#port.release(drone);
    this.#lose(drone);
  }

  async handOver(drone: string, user: string): Promise<void> {
    await this.#port.handOver(drone, user);
    this.#lose(drone);
  }

  async grant(drone: string, user: string): Promise<void> {
    await this.#port.grant(drone, user);
    this.#lose(drone);
  }

  clear(): void {
    this.held = new Map();
  }

  /**
   * Sends the heartbeats when they are due. Called by a timer and by each message of the stream: browsers slow
   * the timers of hidden windows.
   */
  sendHeartbeats(): void {
    const now = this.#now();
    if (this.held.size === 0 || now - this.#lastHeartbeat < HEARTBEAT_MILLISECONDS) {
      return;
    }
    this.#lastHeartbeat = now;
    for (const [drone, epoch] of this.held) {
      void this.#heartbeat(drone, epoch);
    }
  }

  async #heartbeat(drone: string, epoch: number): Promise<void> {
    try {
      const control = await this.#port.heartbeat(drone, epoch);
      if (this.held.get(drone) === epoch && control.epoch !== epoch) {
        // The server was restarted and gave the lease another epoch.
        this.#hold(drone, control);
      }
    } catch (thrown) {
      // Without an answer the lease is still held: the connection may be back in time.
      if (thrown instanceof Problem && thrown.status >= 400 && thrown.status < 500) {
        this.#loseIf(drone, epoch);
      }
    }
  }

  #hold(drone: string, control: Control): void {
    this.held = new Map(this.held).set(drone, control.epoch);
  }

  #loseIf(drone: string, epoch: number): void {
    if (this.held.get(drone) === epoch) {
      this.#lose(drone);
    }
  }

  #lose(drone: string): void {
    const held = new Map(this.held);
    held.delete(drone);
    this.held = held;
  }
}
