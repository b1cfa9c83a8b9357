import type { AccessKey } from './access-keys';

export type Role = 'reporter' | 'viewer' | 'planner' | 'operator' | 'supervisor' | 'administrator';

/** Least first; each may do all that the ones before it may. */
export const ROLES: readonly Role[] = [
  'reporter',
  'viewer',
  'planner',
  'operator',
  'supervisor',
  'administrator',
];

export const WHAT_ROLES_DO: Record<Role, string> = {
  reporter: 'sends reports, sees no drones',
  viewer: 'watches',
  planner: 'prepares missions and fences',
  operator: 'commands drones',
  supervisor: 'commands, and answers for safety',
  administrator: 'manages users and the server',
};

export function mayAct(role: Role | undefined, needed: Role): boolean {
  return role !== undefined && ROLES.indexOf(role) >= ROLES.indexOf(needed);
}

export interface Session {
  name: string;
  role: Role;
  mustChangePassword: boolean;
  /** The name of the organisation; null: the one that runs the server. */
  organisation?: string | null;
}

export interface User {
  name: string;
  role: Role;
  state: 'waiting' | 'active' | 'disabled';
  mustChangePassword: boolean;
  /** Sees no drone by the role alone. */
  onlyGranted: boolean;
}

export interface NewUser {
  name: string;
  role: Role;
  password: string;
}

export interface OneTimePassword {
  name: string;
  password: string;
}

export interface Invitation {
  id: string;
  label: string;
  role: Role;
  invitedBy: string;
  expiresAt: string;
}

/** The code is shown this once and never again. */
export interface NewInvitation extends Invitation {
  code: string;
}

export type RegistrationPolicy = 'approval' | 'invitation' | 'off';

/** How people come in: by an account that they ask for, by a provider that they sign in with. */
export interface WaysIn {
  policy: RegistrationPolicy;
  signInWith: string | null;
}

/** Where a browser goes to sign in with the provider. */
export const PROVIDER_ADDRESS = '/api/v1/session/oidc';

export interface Registered {
  name: string;
  role: Role;
  state: 'waiting' | 'active';
}

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls about users, invitations and registration. */
export class AccountCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async users(): Promise<User[]> {
    return (await this.#call<{ users: User[] }>('GET', '/users')).users;
  }

  add(user: NewUser): Promise<User> {
    return this.#call('POST', '/users', user);
  }

  change(name: string, change: { role?: Role; state?: 'active' | 'disabled' }): Promise<User> {
    return this.#call('PATCH', `/users/${encodeURIComponent(name)}`, change);
  }

  resetPassword(name: string): Promise<OneTimePassword> {
    return this.#call('POST', `/users/${encodeURIComponent(name)}/password`);
  }

  signOut(name: string): Promise<void> {
    return this.#call('POST', `/users/${encodeURIComponent(name)}/sign-out`);
  }

  async keysOf(name: string): Promise<AccessKey[]> {
    const path = `/users/${encodeURIComponent(name)}/access-keys`;
    return (await this.#call<{ accessKeys: AccessKey[] }>('GET', path)).accessKeys;
  }

  revokeKeyOf(name: string, id: string): Promise<void> {
    return this.#call('DELETE', `/users/${encodeURIComponent(name)}/access-keys/${encodeURIComponent(id)}`);
  }

  remove(name: string): Promise<void> {
    return this.#call('DELETE', `/users/${encodeURIComponent(name)}`);
  }

  async invitations(): Promise<Invitation[]> {
    return (await this.#call<{ invitations: Invitation[] }>('GET', '/invitations')).invitations;
  }

  /** Into an organisation other than one's own only for those who run the server. */
  invite(label: string, role: Role, organisation?: string): Promise<NewInvitation> {
    return this.#call('POST', '/invitations', { label, role, ...(organisation ? { organisation } : {}) });
  }

  withdraw(id: string): Promise<void> {
    return this.#call('DELETE', `/invitations/${encodeURIComponent(id)}`);
  }

  waysIn(): Promise<WaysIn> {
    return this.#call('GET', '/registrations');
  }

  register(name: string, password: string, invitation: string | null): Promise<Registered> {
    return this.#call('POST', '/registrations', { name, password, invitation });
  }
}
