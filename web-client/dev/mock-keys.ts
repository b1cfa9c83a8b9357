// The access keys of the mock server.
import { randomUUID } from 'node:crypto';
import type { AccessKey, AccessKeyRequest } from '../src/api/access-keys';
import type { Role } from '../src/api/accounts';
import type { Handler } from './mock-rest';
import { needed, Refusal } from './refusal';

const DAY_MILLISECONDS = 86_400_000;

export class MockKeys {
  #keys: AccessKey[] = [];
  readonly #role: () => Role;

  /** `role`: of who is signed in. */
  constructor(role: () => Role) {
    this.#role = role;
  }

  readonly handlers: Record<string, Handler> = {
    listAccessKeys: () => ({ accessKeys: this.#keys }),
    makeAccessKey: (body: AccessKeyRequest) => {
      const made = this.#made(body);
      this.#keys = [...this.#keys, made];
      return withSecret(made);
    },
    renewAccessKey: (_, id) => {
      const found = this.#keys.find((key) => key.id === id);
      if (found === undefined) {
        throw new Refusal(404, 'access-key-unknown', `There is no access key ${id}.`, { parameters: { id } });
      }
      return withSecret(found);
    },
    deleteAccessKey: (_, id) => {
      this.#keys = this.#keys.filter((key) => key.id !== id);
    },
  };

  #made({ label, operations, days, ...bounds }: AccessKeyRequest): AccessKey {
    return {
      id: randomUUID(),
      label: needed(label, 'label', '1 to 60 characters'),
      role: bounds.role ?? this.#role(),
      operations: operations ?? ['view'],
      drones: bounds.drones ?? null,
      area: bounds.area ?? null,
      floor: bounds.floor ?? null,
      ceiling: bounds.ceiling ?? null,
      altitudeReference: bounds.altitudeReference ?? null,
      expiresAt:
        days === undefined || days === null
          ? null
          : new Date(Date.now() + days * DAY_MILLISECONDS).toISOString(),
      parent: null,
      createdAt: new Date().toISOString(),
      lastUsedAt: null,
      key: null,
    };
  }
}

function withSecret(key: AccessKey): AccessKey {
  return { ...key, key: `dmk_${randomUUID().replaceAll('-', '')}` };
}
