import type {
  OutletView as OutletStatus,
  OwnOutletView as OwnOutlet,
  OutletPortView as PersonalPort,
  RestOperations,
} from '@dronemap/client';

export type { OutletStatus, OwnOutlet, PersonalPort };
export type { OutletClientView as OutletClient, OutletRefusedView as OutletRefused } from '@dronemap/client';

/** The calls around attaching ground stations of other makers. */
export class OutletCalls {
  readonly #rest: RestOperations;

  constructor(rest: RestOperations) {
    this.#rest = rest;
  }

  own(): Promise<OwnOutlet> {
    return this.#rest.getOutlet();
  }

  /** Creates a passphrase; it is returned this once. */
  async newPassphrase(): Promise<string> {
    return (await this.#rest.setOutletPassphrase({})).passphrase;
  }

  clearPassphrase(): Promise<void> {
    return this.#rest.clearOutletPassphrase();
  }

  /** For one hour up to 24. */
  openPort(address: string, hours: number): Promise<PersonalPort> {
    return this.#rest.openOutletPort({ address, hours });
  }

  closePort(id: string): Promise<void> {
    return this.#rest.closeOutletPort({ id });
  }

  all(): Promise<OutletStatus> {
    return this.#rest.listOutletClients();
  }

  disconnect(id: string): Promise<void> {
    return this.#rest.disconnectOutletClient({ id });
  }
}
