/** A ground station or program of another maker that is attached. */
export interface OutletClient {
  id: string;
  user: string;
  address: string;
  transport: string;
  /** Its own. */
  systemId: number;
  /** How many it is shown. */
  drones: number;
  since: string;
  messagesPerSecondIn: number;
  messagesPerSecondOut: number;
  /** Messages that found no room on their way to it. */
  dropped: number;
  silentSeconds: number;
}

/** Messages that stayed outside; `turnedAway`: signed rightly, by somebody who may not attach. */
export interface OutletRefused {
  unsigned: number;
  badSignature: number;
  replayed: number;
  tooOld: number;
  turnedAway: number;
  /** At a personal port, from where it is not bound to. */
  elsewhere: number;
}

/** A port for a program that cannot sign: it looks, and changes nothing. */
export interface PersonalPort {
  id: string;
  endpoint: string;
  /** From where it may be spoken to: an address or a network. */
  address: string;
  /** Who has it; null: nobody has spoken there yet. */
  peer: string | null;
  /** Messages from elsewhere. */
  refused: number;
  until: string;
}

/** Where to attach, and what of one's own is attached. */
export interface OwnOutlet {
  endpoints: string[];
  passphraseSet: boolean;
  clients: OutletClient[];
  ports: PersonalPort[];
}

/** All that is attached. */
export interface OutletStatus {
  endpoints: string[];
  clients: OutletClient[];
  refused: OutletRefused;
}

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

  /** Makes one up; this is the only time that it is told. */
  async newPassphrase(): Promise<string> {
    return (await this.#call<{ passphrase: string }>('PUT', '/outlet/passphrase', {})).passphrase;
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
