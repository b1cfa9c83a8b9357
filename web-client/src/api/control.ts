import type { ControlView as Control } from './contract';

export type { Control };
export type {
  ControlAskedView as ControlRequest,
  OutlookView as Outlook,
  DroneCloudLossView as CloudLossState,
} from './contract';

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls about control of a drone; each returns the new state of the lease. */
export class ControlCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  take(drone: string): Promise<Control> {
    return this.#post(drone, 'take', {});
  }

  request(drone: string, reason: string): Promise<Control> {
    return this.#post(drone, 'request', { reason });
  }

  grant(drone: string, user: string): Promise<Control> {
    return this.#post(drone, 'grant', { user });
  }

  refuse(drone: string, user: string): Promise<Control> {
    return this.#post(drone, 'refuse', { user });
  }

  handOver(drone: string, user: string): Promise<Control> {
    return this.#post(drone, 'hand-over', { user });
  }

  takeOver(drone: string, reason: string): Promise<Control> {
    return this.#post(drone, 'take-over', { reason });
  }

  heartbeat(drone: string, epoch: number): Promise<Control> {
    return this.#post(drone, 'heartbeat', { epoch });
  }

  release(drone: string): Promise<Control> {
    return this.#call('DELETE', `/drones/${encodeURIComponent(drone)}/control`);
  }

  #post(drone: string, action: string, body: unknown): Promise<Control> {
    return this.#call('POST', `/drones/${encodeURIComponent(drone)}/control/${action}`, body);
  }
}
