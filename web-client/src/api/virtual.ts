import type { WithItems } from './items';
import type {
  DroneActionView as Action,
  VirtualDroneDroneName as DroneName,
  VirtualDroneNeedsView as Needs,
  WarehouseProspectsView as Prospects,
  VirtualDroneRequest,
  VirtualDroneView,
  VirtualDroneRunView as VirtualRun,
  WarehouseView,
} from './contract';

export type { DroneName, Prospects, VirtualRun };
export type { WarehouseProspectView as Prospect, VirtualDroneLiveView as VirtualLive } from './contract';

/** Whole, as the server answers it: its description is of what it takes as well. */
export type VirtualNeeds = Required<Needs> & { capabilities: NonNullable<Needs['capabilities']> };

export type VirtualDrone = Omit<WithItems<VirtualDroneView>, 'needs' | 'actions'> & {
  needs: VirtualNeeds;
  actions: Record<'plan' | 'start' | 'stop' | 'resume' | 'remove', Action>;
};

export type VirtualRequest = Required<VirtualDroneRequest>;

export type VirtualState = VirtualRun['state'];

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls around virtual drones and the drones that may serve them. */
export class VirtualCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async all(): Promise<VirtualDrone[]> {
    return (await this.#call<{ virtualDrones: VirtualDrone[] }>('GET', '/virtual-drones')).virtualDrones;
  }

  add(request: VirtualRequest): Promise<VirtualDrone> {
    return this.#call('POST', '/virtual-drones', request);
  }

  replace(id: string, request: VirtualRequest): Promise<VirtualDrone> {
    return this.#call('PUT', one(id), request);
  }

  act(id: string, action: 'start' | 'stop' | 'resume'): Promise<VirtualDrone> {
    return this.#call('POST', `${one(id)}/${action}`, {});
  }

  remove(id: string): Promise<void> {
    return this.#call('DELETE', one(id));
  }

  async pool(): Promise<DroneName[]> {
    return (await this.#call<WarehouseView>('GET', '/warehouse')).drones;
  }

  /** The flights that would follow if that drone were in the pool and nobody had control of it. Changes nothing. */
  prospects(drone: string): Promise<Prospects> {
    return this.#call('GET', `/warehouse/${encodeURIComponent(drone)}/prospects`);
  }

  async offer(drone: string): Promise<DroneName[]> {
    const path = `/warehouse/${encodeURIComponent(drone)}`;
    return (await this.#call<WarehouseView>('PUT', path, {})).drones;
  }

  withdraw(drone: string): Promise<void> {
    return this.#call('DELETE', `/warehouse/${encodeURIComponent(drone)}`);
  }
}

function one(id: string): string {
  return `/virtual-drones/${encodeURIComponent(id)}`;
}
