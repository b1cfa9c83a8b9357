import type { KeyOperation } from './access-keys';

export interface Group {
  id: string;
  name: string;
  members: string[];
  /** Its members see nothing but what they, or it, were granted. */
  onlyGranted: boolean;
}

export interface Fleet {
  id: string;
  name: string;
  drones: string[];
}

/** Whom a grant is for: one of them is null. */
export interface Subject {
  user: string | null;
  group: string | null;
}

export interface Grant extends Subject {
  id: string;
  all: boolean;
  /** Their own virtual drones alone. */
  virtual: boolean;
  drones: string[] | null;
  /** The id of a fleet. */
  fleet: string | null;
  operations: KeyOperation[];
  from: string;
  /** null: until it is taken back. */
  until: string | null;
  state: 'inForce' | 'toCome' | 'over';
  by: string;
  at: string;
}

/** From now on, with exactly one of all, virtual, drones and fleet. */
export interface GrantRequest {
  user?: string;
  group?: string;
  all?: true;
  virtual?: true;
  drones?: string[];
  fleet?: string;
  operations: KeyOperation[];
  until?: string;
}

export interface Organisation {
  id: string;
  name: string;
  users: number;
  drones: number;
  /** null: the one that is always there. */
  madeAt: string | null;
}

/** A drone that was given to an organisation. */
export interface Gift {
  drone: string;
  droneName: string;
  at: string;
  /** Whether what it did before went along. */
  histories: boolean;
  /** What goes along and what does not, sentences. */
  notice: string;
}

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls about organisations, groups, fleets and grants. */
export class GrantCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async all(): Promise<Grant[]> {
    return (await this.#call<{ grants: Grant[] }>('GET', '/grants')).grants;
  }

  add(grant: GrantRequest): Promise<Grant> {
    return this.#call('POST', '/grants', grant);
  }

  takeBack(id: string): Promise<void> {
    return this.#call('DELETE', `/grants/${encodeURIComponent(id)}`);
  }

  setOnlyGranted(of: Subject, onlyGranted: boolean): Promise<void> {
    const whom = of.user === null ? `groups/${of.group ?? ''}` : `users/${encodeURIComponent(of.user)}`;
    return this.#call('PUT', `/${whom}/only-granted`, { onlyGranted });
  }

  async groups(): Promise<Group[]> {
    return (await this.#call<{ groups: Group[] }>('GET', '/groups')).groups;
  }

  /** Without an id a new one. */
  saveGroup(name: string, members: string[], id?: string): Promise<Group> {
    return id === undefined
      ? this.#call('POST', '/groups', { name, members })
      : this.#call('PUT', `/groups/${encodeURIComponent(id)}`, { name, members });
  }

  removeGroup(id: string): Promise<void> {
    return this.#call('DELETE', `/groups/${encodeURIComponent(id)}`);
  }

  async fleets(): Promise<Fleet[]> {
    return (await this.#call<{ fleets: Fleet[] }>('GET', '/fleets')).fleets;
  }

  /** Without an id a new one. */
  saveFleet(name: string, drones: string[], id?: string): Promise<Fleet> {
    return id === undefined
      ? this.#call('POST', '/fleets', { name, drones })
      : this.#call('PUT', `/fleets/${encodeURIComponent(id)}`, { name, drones });
  }

  removeFleet(id: string): Promise<void> {
    return this.#call('DELETE', `/fleets/${encodeURIComponent(id)}`);
  }

  async organisations(): Promise<Organisation[]> {
    return (await this.#call<{ organisations: Organisation[] }>('GET', '/organisations')).organisations;
  }

  addOrganisation(name: string): Promise<Organisation> {
    return this.#call('POST', '/organisations', { name });
  }

  removeOrganisation(id: string): Promise<void> {
    return this.#call('DELETE', of(id));
  }

  async givenTo(organisation: string): Promise<Gift[]> {
    return (await this.#call<{ gifts: Gift[] }>('GET', `${of(organisation)}/drones`)).gifts;
  }

  giveDrone(organisation: string, drone: string, histories: boolean): Promise<Gift> {
    return this.#call('PUT', `${of(organisation)}/drones/${encodeURIComponent(drone)}`, { histories });
  }

  bringBack(organisation: string, drone: string): Promise<Gift> {
    return this.#call('DELETE', `${of(organisation)}/drones/${encodeURIComponent(drone)}`);
  }
}

function of(organisation: string): string {
  return `/organisations/${encodeURIComponent(organisation)}`;
}
