import type {
  OutletView as OutletStatus,
  OwnOutletView as OwnOutlet,
  PassphraseView,
  OutletPortView as PersonalPort,
} from './contract';

export type { OutletStatus, OwnOutlet, PersonalPort };
export type { OutletClientView as OutletClient, OutletRefusedView as OutletRefused } from './contract';

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls around attaching ground stations of other makers. */
export class OutletCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  own(): Promise<OwnOutlet> {
    return this.#call('GET', '/outlet');
  }

  /** Creates a passphrase; it is returned this once. */
  async newPassphrase(): Promise<string> {
    return (await this.#call<PassphraseView>('PUT', '/outlet/passphrase', {})).passphrase;
  }

  clearPassphrase(): Promise<void> {
    return this.#call('DELETE', '/outlet/passphrase');
  }

  /** For one hour up to 24. */
  openPort(address: string, hours: number): Promise<PersonalPort> {
    return this.#call('POST', '/outlet/ports', { address, hours });
  }

  closePort(id: string): Promise<void> {
    return this.#call('DELETE', `/outlet/ports/${encodeURIComponent(id)}`);
  }

  all(): Promise<OutletStatus> {
    return this.#call('GET', '/outlet/clients');
  }

  disconnect(id: string): Promise<void> {
    return this.#call('DELETE', `/outlet/clients/${encodeURIComponent(id)}`);
  }
}
