import type { AccessKey } from './access-keys';
import type {
  AccessKeys,
  InvitationView as Invitation,
  Invitations,
  NewUser,
  OneTimePassword,
  RegistrationAnswer as Registered,
  SessionView as Session,
  UserView as User,
  UserChange,
  Users,
  RegistrationPolicy as RegistrationOptions,
} from './contract';

export type { Invitation, NewUser, OneTimePassword, Registered, Session, User, RegistrationOptions };

export type Role = Session['role'];

/** A new invitation: its code is shown this once and never again. */
export type NewInvitation = Invitation & { code: string };

export type RegistrationPolicy = RegistrationOptions['policy'];

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

/** The address to sign in with the provider. */
export const PROVIDER_ADDRESS = '/api/v1/session/oidc';

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls about users, invitations and registration. */
export class AccountCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async users(): Promise<User[]> {
    return (await this.#call<Users>('GET', '/users')).users;
  }

  add(user: NewUser): Promise<User> {
    return this.#call('POST', '/users', user);
  }

  change(name: string, change: UserChange): Promise<User> {
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
    return (await this.#call<AccessKeys>('GET', path)).accessKeys;
  }

  revokeKeyOf(name: string, id: string): Promise<void> {
    return this.#call('DELETE', `/users/${encodeURIComponent(name)}/access-keys/${encodeURIComponent(id)}`);
  }

  remove(name: string): Promise<void> {
    return this.#call('DELETE', `/users/${encodeURIComponent(name)}`);
  }

  async invitations(): Promise<Invitation[]> {
    return (await this.#call<Invitations>('GET', '/invitations')).invitations;
  }

  /** Into an organisation other than one's own only for those who run the server. */
  invite(label: string, role: Role, organisation?: string): Promise<NewInvitation> {
    return this.#call('POST', '/invitations', { label, role, ...(organisation ? { organisation } : {}) });
  }

  withdraw(id: string): Promise<void> {
    return this.#call('DELETE', `/invitations/${encodeURIComponent(id)}`);
  }

  registrationOptions(): Promise<RegistrationOptions> {
    return this.#call('GET', '/registrations');
  }

  register(name: string, password: string, invitation: string | null): Promise<Registered> {
    return this.#call('POST', '/registrations', { name, password, invitation });
  }
}
