import type { RestOperations } from './contract/operations.js';
import type { SessionView } from './contract/schemas.js';
import { Drone } from './drone.js';
import { RestClient, type Fetch } from './rest/rest-client.js';
import { systemTimers, type SocketClass, type Timers } from './stream/stream-client.js';
import { SharedStream } from './watch/shared-stream.js';
import { eventsOf, type DroneEvent, type EventsOptions } from './watch/events.js';
import { changesOf, readable, type Change, type ChangesOptions } from './watch/watching.js';

interface Place {
  /** Where the server is, such as https://drones.example; a page may leave it out: where it came from. */
  readonly url?: string | undefined;
  /** In place of the global one. */
  readonly fetch?: Fetch | undefined;
  /** In place of the global one; needed on Node before version 22, such as that of the package ws. */
  readonly WebSocket?: SocketClass | undefined;
  /** For tests: in place of the system's clock. */
  readonly timers?: Timers | undefined;
  /** Ends what connect itself asks. */
  readonly signal?: AbortSignal | undefined;
}

/** Programs show an access key; a page has the session of whoever signed in there. */
export type ConnectOptions = Place & ({ readonly key: string } | { readonly session: true });

/** A connection to one server, for one user. */
export class Dronemap implements AsyncDisposable {
  /** Each operation of REST by its id. */
  readonly rest: RestOperations;
  readonly user: SessionView;
  readonly #client: RestClient;
  readonly #stream: SharedStream;
  readonly #timers: Timers;

  private constructor(client: RestClient, stream: SharedStream, timers: Timers, user: SessionView) {
    this.#client = client;
    this.rest = client.operations;
    this.#stream = stream;
    this.#timers = timers;
    this.user = user;
  }

  /** @throws Problem when the key or session is none, or the server cannot be reached */
  static async connect(options: ConnectOptions): Promise<Dronemap> {
    const { fetch, WebSocket: socketClass, timers = systemTimers, signal } = options;
    const url = options.url ?? ownOrigin();
    const key = 'key' in options ? options.key : undefined;
    const client = new RestClient({ url, key, fetch });
    const rest = client.operations;
    const user = await rest.getSession({ signal });
    return new Dronemap(client, new SharedStream({ url, key, rest, socketClass, timers }), timers, user);
  }

  /** As its newest answer said it; null: it does not say. */
  get serverVersion(): string | null {
    return this.#client.serverVersion;
  }

  async drones(options: { readonly signal?: AbortSignal | undefined } = {}): Promise<Drone[]> {
    const { drones } = await this.rest.listDrones({}, options);
    return drones.map((drone) => this.#of(drone));
  }

  /**
   * The drone of that id, else of that name.
   *
   * @throws Error when there is none, or several have that name
   */
  async drone(nameOrId: string, options: { readonly signal?: AbortSignal | undefined } = {}): Promise<Drone> {
    const all = await this.drones(options);
    const byId = all.find(({ id }) => id === nameOrId);
    const named = all.filter(({ name }) => name === nameOrId);
    const [drone, other] = byId === undefined ? named : [byId];
    if (drone === undefined) {
      const names = all.map(({ name }) => name).join(', ');
      throw new Error(
        `There is no drone “${nameOrId}”; there ${names === '' ? 'is none at all' : `are: ${names}`}.`,
      );
    }
    if (other !== undefined) {
      throw new Error(
        `Several drones are called “${nameOrId}”; ask for one by its id: ${named.map(({ id }) => id).join(', ')}.`,
      );
    }
    return drone;
  }

  /** Whatever changes in sight of this user, over lost connections too; a `gap` says that some was missed. */
  changes(options: ChangesOptions = {}): AsyncIterable<Change> {
    return readable(() => changesOf({ stream: this.#stream, rest: this.rest }, options));
  }

  /**
   * What happens to drones, as the server writes it down: none is missed or told twice while it is read, and a program
   * goes on later from the `resume` of what it has read.
   */
  events(options: EventsOptions = {}): AsyncIterable<DroneEvent> {
    return readable(() => eventsOf({ rest: this.rest, timers: this.#timers }, options));
  }

  /** Ends the stream; whoever reads it is told. */
  close(): void {
    this.#stream.end(new Error('The connection to the cloud was closed.'));
  }

  async [Symbol.asyncDispose](): Promise<void> {
    this.close();
  }

  #of(drone: Pick<Drone, 'id' | 'name'>): Drone {
    return new Drone(drone, { rest: this.rest, stream: this.#stream, timers: this.#timers });
  }
}

/** Where the page came from. */
function ownOrigin(): string {
  const { location } = globalThis as { location?: { readonly origin: string } };
  if (location === undefined) {
    throw new Error('Only a page may leave out the url: say where the server is.');
  }
  return location.origin;
}
