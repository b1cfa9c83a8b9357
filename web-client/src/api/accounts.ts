import type { AccessKey } from './access-keys';
import type {
  InvitationView as Invitation,
  NewUser,
  OneTimePassword,
  RegistrationAnswer as Registered,
  SessionView as Session,
  UserView as User,
  UserChange,
  RegistrationPolicy as RegistrationOptions,
  RestOperations,
} from '@dronemap/client';

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

/** The calls about users, invitations and registration. */
export class AccountCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  async users(): Promise<User[]> {
    return (await this.#rest.listUsers()).users;
  }

  add(user: NewUser): Promise<User> {
    return this.#rest.addUser(user);
  }

  change(name: string, change: UserChange): Promise<User> {
    return this.#rest.changeUser({ name }, change);
  }

  resetPassword(name: string): Promise<OneTimePassword> {
    return this.#rest.resetPassword({ name });
  }

  signOut(name: string): Promise<void> {
    return this.#rest.signOutUser({ name });
  }

  async keysOf(name: string): Promise<AccessKey[]> {
    return (await this.#rest.listUserAccessKeys({ name })).accessKeys;
  }

  revokeKeyOf(name: string, id: string): Promise<void> {
    return this.#rest.deleteUserAccessKey({ name, id });
  }

  remove(name: string): Promise<void> {
    return this.#rest.deleteUser({ name });
  }

  async invitations(): Promise<Invitation[]> {
    return (await this.#rest.listInvitations()).invitations;
  }

  /** Into an organisation other than one's own only for those who run the server. */
  invite(label: string, role: Role, organisation?: string): Promise<NewInvitation> {
    const invitation = { label, role, ...(organisation ? { organisation } : {}) };
    return this.#rest.addInvitation(invitation) as Promise<NewInvitation>;
  }

  withdraw(id: string): Promise<void> {
    return this.#rest.withdrawInvitation({ id });
  }

  registrationOptions(): Promise<RegistrationOptions> {
    return this.#rest.getRegistrationPolicy();
  }

  register(name: string, password: string, invitation: string | null): Promise<Registered> {
    return this.#rest.register({ name, password, invitation });
  }
}
