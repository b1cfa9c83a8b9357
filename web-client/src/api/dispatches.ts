import type {
  DispatchNowView as DispatchNow,
  DispatchRequest as DispatchOrder,
  DispatchView as Dispatch,
  RestOperations,
} from '@dronemap/client';

export type { Dispatch, DispatchNow, DispatchOrder };

/** The calls about drones that are sent to a place; each answers the new state of the dispatch. */
export class DispatchCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  async all(): Promise<Dispatch[]> {
    return (await this.#rest.listDispatches()).dispatches;
  }

  send(order: DispatchOrder): Promise<Dispatch> {
    return this.#rest.sendDrone(order);
  }

  cancel(id: string): Promise<Dispatch> {
    return this.#rest.cancelDispatch({ id });
  }
}
