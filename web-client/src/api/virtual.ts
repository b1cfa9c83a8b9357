import type { MissionItem } from './types';

/** What a drone must be to serve; null or nothing: any. */
export interface VirtualNeeds {
  kind: string | null;
  capabilities: string[];
  enduranceMinutes: number | null;
  area: { latitude: number; longitude: number; radius: number } | null;
}

export interface DroneName {
  id: string;
  name: string;
}

export type VirtualState =
  | 'queued'
  | 'uploading'
  | 'arming'
  | 'starting'
  | 'flying'
  | 'returning'
  | 'givingUp'
  | 'stopping'
  | 'suspended'
  | 'done'
  | 'failed'
  | 'stopped';

/** A mission from being asked for to its end. `drone`, `detail` and `unfit` are there only for those who may see the drone. */
export interface VirtualRun {
  state: VirtualState;
  sentence: string;
  queue: { position: number; length: number } | null;
  flown: number;
  total: number;
  onCloudLoss: 'continue' | 'rtl';
  why: string | null;
  drone: DroneName | null;
  detail: string | null;
  unfit: { drone: DroneName; why: string }[];
  changedAt: string;
}

/** How the drone is that serves, without its name. */
export interface VirtualLive {
  link: 'live' | 'suspect' | 'lost' | 'ended';
  armed: boolean | null;
  position: { latitude: number | null; longitude: number | null; altitudeAboveHome: number | null } | null;
  battery: number | null;
}

export interface VirtualDrone {
  id: string;
  name: string;
  owner: string;
  needs: VirtualNeeds;
  items: MissionItem[] | null;
  run: VirtualRun | null;
  live: VirtualLive | null;
  actions: Record<'plan' | 'start' | 'stop' | 'resume' | 'remove', { allowed: boolean; why: string | null }>;
}

/** What waits, as seen from a drone; `flies`: it would arm and take off for it. Names only for those who may see it. */
export interface Prospect {
  name: string | null;
  owner: string | null;
  waypoints: number;
  flies: boolean;
  why: string | null;
}

export interface Prospects {
  inWarehouse: boolean;
  waiting: Prospect[];
}

export interface VirtualRequest {
  name: string;
  needs: VirtualNeeds;
  items: readonly MissionItem[] | null;
}

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

  async warehouse(): Promise<DroneName[]> {
    return (await this.#call<{ drones: DroneName[] }>('GET', '/warehouse')).drones;
  }

  /** What would follow if that drone were in the warehouse and nobody had control of it. Changes nothing. */
  prospects(drone: string): Promise<Prospects> {
    return this.#call('GET', `/warehouse/${encodeURIComponent(drone)}/prospects`);
  }

  async offer(drone: string): Promise<DroneName[]> {
    const path = `/warehouse/${encodeURIComponent(drone)}`;
    return (await this.#call<{ drones: DroneName[] }>('PUT', path, {})).drones;
  }

  withdraw(drone: string): Promise<void> {
    return this.#call('DELETE', `/warehouse/${encodeURIComponent(drone)}`);
  }
}

function one(id: string): string {
  return `/virtual-drones/${encodeURIComponent(id)}`;
}
