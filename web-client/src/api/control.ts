import type { ControlView as Control, RestOperations } from '@dronemap/client';

export type { Control };
export type {
  ControlAskedView as ControlRequest,
  OutlookView as Outlook,
  DroneCloudLossView as CloudLossState,
} from '@dronemap/client';

/** The calls about control of a drone; each returns the new state of the lease. */
export class ControlCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  take(drone: string): Promise<Control> {
    return this.#rest.takeControl({ id: drone });
  }

  request(drone: string, reason: string): Promise<Control> {
    return this.#rest.requestControl({ id: drone }, { reason });
  }

  grant(drone: string, user: string): Promise<Control> {
    return this.#rest.grantControl({ id: drone }, { user });
  }

  refuse(drone: string, user: string): Promise<Control> {
    return this.#rest.refuseControl({ id: drone }, { user });
  }

  handOver(drone: string, user: string): Promise<Control> {
    return this.#rest.handOverControl({ id: drone }, { user });
  }

  takeOver(drone: string, reason: string): Promise<Control> {
    return this.#rest.takeOverControl({ id: drone }, { reason });
  }

  heartbeat(drone: string, epoch: number): Promise<Control> {
    return this.#rest.keepControl({ id: drone }, { epoch });
  }

  release(drone: string): Promise<Control> {
    return this.#rest.releaseControl({ id: drone });
  }
}
