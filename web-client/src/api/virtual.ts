import type { WithItems } from './items';
import type {
  DroneActionView as Action,
  VirtualDroneDroneName as DroneName,
  VirtualDroneNeedsView as Needs,
  WarehouseProspectsView as Prospects,
  VirtualDroneRequest,
  VirtualDroneView,
  VirtualDroneRunView as VirtualRun,
  RestOperations,
} from '@dronemap/client';

export type { DroneName, Prospects, VirtualRun };
export type {
  WarehouseProspectView as Prospect,
  VirtualDroneShareView as VirtualShare,
  VirtualDroneLiveView as VirtualLive,
} from '@dronemap/client';

/** Whole, as the server answers it: its description is of what it takes as well. */
export type VirtualNeeds = Required<Needs> & { capabilities: NonNullable<Needs['capabilities']> };

export type VirtualDrone = Omit<WithItems<VirtualDroneView>, 'needs' | 'actions'> & {
  needs: VirtualNeeds;
  actions: Record<'plan' | 'start' | 'stop' | 'resume' | 'remove', Action>;
};

export type VirtualRequest = Required<VirtualDroneRequest>;

export type VirtualState = VirtualRun['state'];

/** The calls around virtual drones and the drones that may serve them. */
export class VirtualCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  async all(): Promise<VirtualDrone[]> {
    return (await this.#rest.listVirtualDrones()).virtualDrones as VirtualDrone[];
  }

  add(request: VirtualRequest): Promise<VirtualDrone> {
    return this.#rest.addVirtualDrone(request) as Promise<VirtualDrone>;
  }

  replace(id: string, request: VirtualRequest): Promise<VirtualDrone> {
    return this.#rest.replaceVirtualDrone({ id }, request) as Promise<VirtualDrone>;
  }

  act(id: string, action: 'start' | 'stop' | 'resume'): Promise<VirtualDrone> {
    return this.#rest[ACTIONS[action]]({ id }) as Promise<VirtualDrone>;
  }

  remove(id: string): Promise<void> {
    return this.#rest.removeVirtualDrone({ id });
  }

  async pool(): Promise<DroneName[]> {
    return (await this.#rest.listWarehouse()).drones;
  }

  /** The flights that would follow if that drone were in the pool and nobody had control of it. Changes nothing. */
  prospects(drone: string): Promise<Prospects> {
    return this.#rest.getProspects({ id: drone });
  }

  async offer(drone: string): Promise<DroneName[]> {
    return (await this.#rest.putIntoWarehouse({ id: drone })).drones;
  }

  withdraw(drone: string): Promise<void> {
    return this.#rest.takeFromWarehouse({ id: drone });
  }
}

const ACTIONS = {
  start: 'startVirtualDrone',
  stop: 'stopVirtualDrone',
  resume: 'resumeVirtualDrone',
} as const satisfies Record<string, keyof RestOperations>;
