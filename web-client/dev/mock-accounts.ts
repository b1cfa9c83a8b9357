// The accounts of the mock server: who is signed in, users, invitations, registration.
import { randomUUID } from 'node:crypto';
import type { Invitation, NewUser, Role, Session, User, RegistrationOptions } from '../src/api/accounts';
import type {
  Credentials,
  NewInvitation,
  PasswordRequest,
  RegistrationRequest,
  UserChange,
} from '@dronemap/client';
import { WithStatus, type Handler } from './mock-rest';
import { needed, Refusal } from './refusal';

const WEEK_MILLISECONDS = 7 * 86_400_000;
const NAME = '1 to 60 characters';

export class MockAccounts {
  #session: Session | null = null;
  #users: User[] = [
    { name: 'admin', role: 'administrator', state: 'active', mustChangePassword: false, onlyGranted: false },
    { name: 'ann', role: 'viewer', state: 'waiting', mustChangePassword: false, onlyGranted: false },
  ];
  #invitations: Invitation[] = [];

  readonly handlers: Record<string, Handler> = {
    signIn: (body: Credentials) => this.#signIn(body),
    getSession: () => this.#session,
    signOut: () => {
      this.#session = null;
    },
    signOutEverywhere: () => {
      this.#session = null;
    },
    changePassword: (_: PasswordRequest) => {
      this.#session = this.#session && { ...this.#session, mustChangePassword: false };
    },
    listUsers: () => ({ users: this.#users }),
    addUser: ({ name, role }: NewUser) =>
      this.#add({
        name: needed(name, 'name', NAME),
        role: needed(role, 'role', 'one of the roles'),
        state: 'active',
        mustChangePassword: true,
        onlyGranted: false,
      }),
    changeUser: ({ role, state }: UserChange, name) => {
      const was = this.#user(name);
      const changed = { ...was, role: role ?? was.role, state: state ?? was.state };
      this.#users = this.#users.map((user) => (user === was ? changed : user));
      return changed;
    },
    deleteUser: (_, name) => {
      this.#users = this.#users.filter((user) => user.name !== name);
    },
    resetPassword: (_, name) => ({ name: this.#user(name).name, password: 'first-password' }),
    signOutUser: () => undefined,
    listInvitations: () => ({ invitations: this.#invitations.map((one) => ({ ...one, code: null })) }),
    addInvitation: (body: NewInvitation) => this.#invite(body),
    withdrawInvitation: (_, id) => {
      this.#invitations = this.#invitations.filter((one) => one.id !== id);
    },
    getRegistrationPolicy: () => ({ policy: 'approval', signInWith: null }) satisfies RegistrationOptions,
    register: (body: RegistrationRequest) => this.#register(body),
  };

  /** Who is signed in, for all who connect; null: nobody. */
  get session(): Session | null {
    return this.#session;
  }

  get name(): string {
    return this.#session?.name ?? 'nobody';
  }

  get role(): Role {
    return this.#session?.role ?? 'viewer';
  }

  #signIn({ name, password }: Credentials): Session {
    if (!['flight-deck', 'first-password'].includes(password ?? '')) {
      throw new Refusal(401, 'credentials-wrong', 'The name or the password is not right.');
    }
    this.#session = {
      name: needed(name, 'name', NAME),
      role: name === 'viewer' ? 'viewer' : 'administrator',
      mustChangePassword: password === 'first-password',
      organisation: null,
    };
    return this.#session;
  }

  #user(name: string): User {
    const found = this.#users.find((user) => user.name === name);
    if (found === undefined) {
      throw new Refusal(404, 'user-unknown', `There is no user ${name}.`, { parameters: { id: name } });
    }
    return found;
  }

  #add(user: User): User {
    this.#users = [...this.#users, user];
    return user;
  }

  #invite({ label, role }: NewInvitation): Invitation {
    const made = {
      id: randomUUID(),
      label: needed(label, 'label', NAME),
      role: needed(role, 'role', 'one of the roles'),
      invitedBy: this.name,
      expiresAt: new Date(Date.now() + WEEK_MILLISECONDS).toISOString(),
      code: randomUUID(),
    };
    this.#invitations = [...this.#invitations, made];
    return made;
  }

  #register({ name, invitation }: RegistrationRequest): WithStatus {
    const found = this.#invitations.find((one) => one.code === invitation);
    this.#invitations = this.#invitations.filter((one) => one !== found);
    const user = this.#add({
      name: needed(name, 'name', NAME),
      role: found?.role ?? 'viewer',
      state: found === undefined ? 'waiting' : 'active',
      mustChangePassword: false,
      onlyGranted: false,
    });
    const { role, state } = user;
    return new WithStatus(state === 'active' ? 201 : 202, { name: user.name, role, state });
  }
}
