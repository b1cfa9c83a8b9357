// The accounts of the mock server: users, invitations, registration.
import { randomUUID } from 'node:crypto';
import type { NewInvitation, User } from '../src/api/accounts';

export type Handler = (body: never, id: string) => unknown;

export class MockAccounts {
  #users: User[] = [
    { name: 'admin', role: 'administrator', state: 'active', mustChangePassword: false, onlyGranted: false },
    { name: 'ann', role: 'viewer', state: 'waiting', mustChangePassword: false, onlyGranted: false },
  ];
  #invitations: NewInvitation[] = [];

  readonly handlers: Record<string, Handler> = {
    'GET users': () => ({ users: this.#users }),
    'POST users': (body: { name: string; role: User['role'] }) =>
      this.#add({
        name: body.name,
        role: body.role,
        state: 'active',
        mustChangePassword: true,
        onlyGranted: false,
      }),
    'PATCH users/*': (body: Partial<User>, name) => {
      this.#users = this.#users.map((user) => (user.name === name ? { ...user, ...body } : user));
      return this.#users.find((user) => user.name === name);
    },
    'DELETE users/*': (_, name) => {
      this.#users = this.#users.filter((user) => user.name !== name);
    },
    'POST users/*/password': (_, name) => ({ name, password: 'first-password' }),
    'POST users/*/sign-out': () => undefined,
    'GET invitations': () => ({ invitations: this.#invitations.map(({ code: _, ...shown }) => shown) }),
    'POST invitations': (body: Pick<NewInvitation, 'label' | 'role'>) => this.#invite(body),
    'DELETE invitations/*': (_, id) => {
      this.#invitations = this.#invitations.filter((one) => one.id !== id);
    },
    'GET registrations': () => ({ policy: 'approval' }),
    'POST registrations': (body: { name: string; invitation: string | null }) => this.#register(body),
  };

  #add(user: User): User {
    this.#users = [...this.#users, user];
    return user;
  }

  #invite({ label, role }: Pick<NewInvitation, 'label' | 'role'>): NewInvitation {
    const expiresAt = new Date(Date.now() + 7 * 86_400_000).toISOString();
    const made = { id: randomUUID(), label, role, invitedBy: 'admin', expiresAt, code: randomUUID() };
    this.#invitations = [...this.#invitations, made];
    return made;
  }

  #register({ name, invitation }: { name: string; invitation: string | null }): User {
    const found = this.#invitations.find((one) => one.code === invitation);
    this.#invitations = this.#invitations.filter((one) => one !== found);
    const state = found === undefined ? 'waiting' : 'active';
    return this.#add({
      name,
      role: found?.role ?? 'viewer',
      state,
      mustChangePassword: false,
      onlyGranted: false,
    });
  }
}
