import type { RestClient } from '../api/rest';
import { Roster } from './roster.svelte';

type Calls = Pick<RestClient, 'accounts' | 'grants' | 'accessKeys' | 'endpoints' | 'missions'>;

/**
 * The lists of the server that more than one part of the page shows, each once: what is changed in one place is seen in all.
 * A change of one may change the others (whoever is removed leaves groups and grants), so those that are shown are read anew.
 */
export class Directory {
  readonly users;
  readonly invitations;
  readonly groups;
  readonly fleets;
  readonly grants;
  readonly organisations;
  readonly accessKeys;
  readonly endpoints;
  readonly missions;

  constructor(calls: Calls) {
    const kept = <T>(read: () => Promise<readonly T[]>): Roster<T> => {
      const roster: Roster<T> = new Roster(read, () => this.#changed(roster));
      return roster;
    };
    this.users = kept(() => calls.accounts.users());
    this.invitations = kept(() => calls.accounts.invitations());
    this.groups = kept(() => calls.grants.groups());
    this.fleets = kept(() => calls.grants.fleets());
    this.grants = kept(() => calls.grants.all());
    this.organisations = kept(() => calls.grants.organisations());
    this.accessKeys = kept(() => calls.accessKeys.all());
    this.endpoints = kept(() => calls.endpoints());
    this.missions = kept(() => calls.missions());
  }

  /** Another user may see other lists. */
  clear(): void {
    this.#all().forEach((roster) => roster.clear());
  }

  #all(): Roster<unknown>[] {
    return Object.values(this).filter((one): one is Roster<unknown> => one instanceof Roster);
  }

  #changed(changed: Roster<unknown>): void {
    this.#all()
      .filter((roster) => roster !== changed && roster.loaded)
      .forEach((roster) => void roster.refresh());
  }
}
