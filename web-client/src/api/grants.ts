import type {
  FleetView as Fleet,
  Fleets,
  GiftView as Gift,
  Gifts,
  GrantView as Grant,
  GrantRequest,
  Grants,
  GroupView as Group,
  Groups,
  OrganisationView as Organisation,
  Organisations,
} from './contract';

export type { Fleet, Gift, Grant, GrantRequest, Group, Organisation };

/** The holder of a grant: one of them is null. */
export type Subject = Pick<Grant, 'user' | 'group'>;

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls about organisations, groups, fleets and grants. */
export class GrantCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async all(): Promise<Grant[]> {
    return (await this.#call<Grants>('GET', '/grants')).grants;
  }

  add(grant: GrantRequest): Promise<Grant> {
    return this.#call('POST', '/grants', grant);
  }

  revoke(id: string): Promise<void> {
    return this.#call('DELETE', `/grants/${encodeURIComponent(id)}`);
  }

  setOnlyGranted(of: Subject, onlyGranted: boolean): Promise<void> {
    const whom = of.user === null ? `groups/${of.group ?? ''}` : `users/${encodeURIComponent(of.user)}`;
    return this.#call('PUT', `/${whom}/only-granted`, { onlyGranted });
  }

  async groups(): Promise<Group[]> {
    return (await this.#call<Groups>('GET', '/groups')).groups;
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
    return (await this.#call<Fleets>('GET', '/fleets')).fleets;
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
    return (await this.#call<Organisations>('GET', '/organisations')).organisations;
  }

  addOrganisation(name: string): Promise<Organisation> {
    return this.#call('POST', '/organisations', { name });
  }

  removeOrganisation(id: string): Promise<void> {
    return this.#call('DELETE', of(id));
  }

  async givenDrones(organisation: string): Promise<Gift[]> {
    return (await this.#call<Gifts>('GET', `${of(organisation)}/drones`)).gifts;
  }

  giveDrone(organisation: string, drone: string, histories: boolean): Promise<Gift> {
    return this.#call('PUT', `${of(organisation)}/drones/${encodeURIComponent(drone)}`, { histories });
  }

  reclaimDrone(organisation: string, drone: string): Promise<Gift> {
    return this.#call('DELETE', `${of(organisation)}/drones/${encodeURIComponent(drone)}`);
  }
}

function of(organisation: string): string {
  return `/organisations/${encodeURIComponent(organisation)}`;
}
