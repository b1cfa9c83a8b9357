import type { Role } from './accounts';

export type KeyOperation = 'view' | 'plan' | 'command' | 'administer';

/** As in GeoJSON, longitude first; a circle is a point with a radius in metres. */
export interface KeyArea {
  type: string;
  coordinates: unknown;
  radius?: number | null;
}

/** Metres; what is null is no bound. */
export interface KeyBounds {
  area: KeyArea | null;
  floor: number | null;
  ceiling: number | null;
  altitudeReference: 'home' | 'amsl' | null;
}

export interface AccessKey extends KeyBounds {
  id: string;
  label: string;
  role: Role;
  operations: KeyOperation[];
  /** null: all, also those to come. */
  drones: string[] | null;
  /** null: it does not end by itself. */
  expiresAt: string | null;
  /** The key that it was made with; null: none. */
  parent: string | null;
  /** To about a minute; null: not used yet. */
  lastUsedAt: string | null;
}

/** What making or renewing a key answers: the key itself is shown this once and never again. */
export interface NewAccessKey extends AccessKey {
  key: string;
}

/** What is left out is as wide as who asks. */
export interface AccessKeyRequest {
  label: string;
  operations: KeyOperation[];
  drones?: string[];
  area?: KeyArea;
  floor?: number;
  ceiling?: number;
  altitudeReference?: 'home' | 'amsl';
  days?: number;
}

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls about one's own access keys. */
export class AccessKeyCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  async all(): Promise<AccessKey[]> {
    return (await this.#call<{ accessKeys: AccessKey[] }>('GET', '/access-keys')).accessKeys;
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
