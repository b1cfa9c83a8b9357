/** Somebody asks the holder for control. */
export interface ControlRequest {
  by: string;
  reason: string | null;
  at: string;
}

/** Who commands a drone. `explicit`: taken on purpose and kept by heartbeats; else it came with a command. */
export interface Control {
  state: 'free' | 'held' | 'pilot';
  holder: string | null;
  explicit: boolean;
  since: string | null;
  epoch: number;
  requests: ControlRequest[];
}

/** What becomes of a drone in the air when whoever has it has it no more. */
export interface Outlook {
  /** Whose it is: nobody has one that waits, returns or is helpless. */
  state: 'kept' | 'waits' | 'returns' | 'helpless' | 'leftAlone';
  /** A sentence. */
  then: string;
  /** When it is brought home unless somebody takes control; null: it does not come to that now. */
  returnsAt: string | null;
  latitude: number | null;
  longitude: number | null;
  /** What the place is called; null: it would not be brought down, or circles at home. */
  comesDown: string | null;
  emptyAt: string | null;
}

/** What a drone does by itself when it does not hear the cloud any more. */
export interface WithoutCloud {
  state: 'set' | 'notSet' | 'cannotBeSet';
  sentence: string;
}

type Call = <T>(method: string, path: string, body?: unknown) => Promise<T>;

/** The calls around control of a drone; each answers with how it is then. */
export class ControlCalls {
  readonly #call: Call;

  constructor(call: Call) {
    this.#call = call;
  }

  take(drone: string): Promise<Control> {
    return this.#post(drone, 'take', {});
  }

  request(drone: string, reason: string): Promise<Control> {
    return this.#post(drone, 'request', { reason });
  }

  grant(drone: string, user: string): Promise<Control> {
    return this.#post(drone, 'grant', { user });
  }

  refuse(drone: string, user: string): Promise<Control> {
    return this.#post(drone, 'refuse', { user });
  }

  handOver(drone: string, user: string): Promise<Control> {
    return this.#post(drone, 'hand-over', { user });
  }

  takeOver(drone: string, reason: string): Promise<Control> {
    return this.#post(drone, 'take-over', { reason });
  }

  heartbeat(drone: string, epoch: number): Promise<Control> {
    return this.#post(drone, 'heartbeat', { epoch });
  }

  release(drone: string): Promise<Control> {
    return this.#call('DELETE', `/drones/${encodeURIComponent(drone)}/control`);
  }

  #post(drone: string, action: string, body: unknown): Promise<Control> {
    return this.#call('POST', `/drones/${encodeURIComponent(drone)}/control/${action}`, body);
  }
}
