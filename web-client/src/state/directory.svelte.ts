import type { RestClient } from '../api/rest';
import { ServerList } from './server-list.svelte';

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
    const shared = <T>(read: () => Promise<readonly T[]>): ServerList<T> => {
      const list: ServerList<T> = new ServerList(read, () => this.#changed(list));
      return list;
    };
    this.users = shared(() => calls.accounts.users());
    this.invitations = shared(() => calls.accounts.invitations());
    this.groups = shared(() => calls.grants.groups());
    this.fleets = shared(() => calls.grants.fleets());
    this.grants = shared(() => calls.grants.all());
    this.organisations = shared(() => calls.grants.organisations());
    this.accessKeys = shared(() => calls.accessKeys.all());
    this.endpoints = shared(() => calls.endpoints());
    this.missions = shared(() => calls.missions());
  }

  /** Another user may see other lists. */
  clear(): void {
    this.#all().forEach((list) => list.clear());
  }

  #all(): ServerList<unknown>[] {
    return Object.values(this).filter((one): one is ServerList<unknown> => one instanceof ServerList);
  }

  #changed(changed: ServerList<unknown>): void {
    this.#all()
      .filter((list) => list !== changed && list.loaded)
      .forEach((list) => void list.refresh());
  }
}
