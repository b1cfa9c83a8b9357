import type { KeyView as AccessKey, KeyRequest as AccessKeyRequest, RestOperations } from '@dronemap/client';

export type { AccessKey, AccessKeyRequest };
export type { KeyArea } from '@dronemap/client';

/** A new or renewed key: the key itself is shown this once and never again. */
export type NewAccessKey = AccessKey & { key: string };

export type KeyOperation = AccessKey['operations'][number];

/** Metres; what is null is no bound. */
export type KeyBounds = Pick<AccessKey, 'area' | 'floor' | 'ceiling' | 'altitudeReference'>;

/** The calls about one's own access keys. */
export class AccessKeyCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  async all(): Promise<AccessKey[]> {
    return (await this.#rest.listAccessKeys()).accessKeys;
  }

  make(request: AccessKeyRequest): Promise<NewAccessKey> {
    return this.#rest.makeAccessKey(request) as Promise<NewAccessKey>;
  }

  renew(id: string): Promise<NewAccessKey> {
    return this.#rest.renewAccessKey({ id }) as Promise<NewAccessKey>;
  }

  revoke(id: string): Promise<void> {
    return this.#rest.deleteAccessKey({ id });
  }
}
