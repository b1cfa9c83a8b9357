import type {
  FleetView as Fleet,
  GiftView as Gift,
  GrantView as Grant,
  GrantRequest,
  GroupView as Group,
  OrganisationView as Organisation,
  RestOperations,
} from '@dronemap/client';

export type { Fleet, Gift, Grant, GrantRequest, Group, Organisation };

/** The holder of a grant: one of them is null. */
export type Subject = Pick<Grant, 'user' | 'group'>;

/** The calls about organisations, groups, fleets and grants. */
export class GrantCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  async all(): Promise<Grant[]> {
    return (await this.#rest.listGrants()).grants;
  }

  add(grant: GrantRequest): Promise<Grant> {
    return this.#rest.addGrant(grant);
  }

  revoke(id: string): Promise<void> {
    return this.#rest.revokeGrant({ id });
  }

  setOnlyGranted(of: Subject, onlyGranted: boolean): Promise<void> {
    return of.user === null
      ? this.#rest.setGroupOnlyGranted({ id: of.group ?? '' }, { onlyGranted })
      : this.#rest.setUserOnlyGranted({ name: of.user }, { onlyGranted });
  }

  async groups(): Promise<Group[]> {
    return (await this.#rest.listGroups()).groups;
  }

  /** Without an id a new one. */
  saveGroup(name: string, members: string[], id?: string): Promise<Group> {
    return id === undefined
      ? this.#rest.addGroup({ name, members })
      : this.#rest.replaceGroup({ id }, { name, members });
  }

  removeGroup(id: string): Promise<void> {
    return this.#rest.deleteGroup({ id });
  }

  async fleets(): Promise<Fleet[]> {
    return (await this.#rest.listFleets()).fleets;
  }

  /** Without an id a new one. */
  saveFleet(name: string, drones: string[], id?: string): Promise<Fleet> {
    return id === undefined
      ? this.#rest.addFleet({ name, drones })
      : this.#rest.replaceFleet({ id }, { name, drones });
  }

  removeFleet(id: string): Promise<void> {
    return this.#rest.deleteFleet({ id });
  }

  async organisations(): Promise<Organisation[]> {
    return (await this.#rest.listOrganisations()).organisations;
  }

  addOrganisation(name: string): Promise<Organisation> {
    return this.#rest.addOrganisation({ name });
  }

  removeOrganisation(id: string): Promise<void> {
    return this.#rest.deleteOrganisation({ id });
  }

  async givenDrones(organisation: string): Promise<Gift[]> {
    return (await this.#rest.listGivenDrones({ id: organisation })).gifts;
  }

  giveDrone(organisation: string, drone: string, histories: boolean): Promise<Gift> {
    return this.#rest.giveDrone({ id: organisation, drone }, { histories });
  }

  reclaimDrone(organisation: string, drone: string): Promise<Gift> {
    return this.#rest.takeBackDrone({ id: organisation, drone });
  }
}
