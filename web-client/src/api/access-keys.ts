import type { KeyView as AccessKey, KeyRequest as AccessKeyRequest, AccessKeys } from './contract';

export type { AccessKey, AccessKeyRequest };
export type { KeyArea } from './contract';

/** A new or renewed key: the key itself is shown this once and never again. */
export type NewAccessKey = AccessKey & { key: string };

export type KeyOperation = AccessKey['operations'][number];

/** Metres; what is null is no bound. */
export type KeyBounds = Pick<AccessKey, 'area' | 'floor' | 'ceiling' | 'altitudeReference'>;

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls about one's own access keys. */
export class AccessKeyCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async all(): Promise<AccessKey[]> {
    return (await this.#call<AccessKeys>('GET', '/access-keys')).accessKeys;
  }

  make(request: AccessKeyRequest): Promise<NewAccessKey> {
    return this.#call('POST', '/access-keys', request);
  }

  renew(id: string): Promise<NewAccessKey> {
    return this.#call('POST', `/access-keys/${encodeURIComponent(id)}/renew`);
  }

  revoke(id: string): Promise<void> {
    return this.#call('DELETE', `/access-keys/${encodeURIComponent(id)}`);
  }
}
