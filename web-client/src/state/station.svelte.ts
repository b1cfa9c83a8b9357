import { getContext, setContext } from 'svelte';
import { RestClient } from '../api/rest';
import { Problem } from '../api/problem';
import { newUuid, openSocket, StreamClient, streamAddress, systemTimers } from '@dronemap/client';
import { mayAct, type Role, type Session } from '../api/accounts';
import type { Positions, Receipt } from '../api/follows';
import type { CommandKind, Drone, Settings, StreamMessage } from '../api/types';
import { CloudClock } from './clock.svelte';
import { Commands } from './commands.svelte';
import { Connection } from './connection.svelte';
import { ControlLeases } from './control-leases.svelte';
import { ViewState } from './view-state.svelte';
import { Directory } from './directory.svelte';
import { Dispatches } from './dispatches.svelte';
import { Recoveries } from './recoveries.svelte';
import { Fleet } from './fleet.svelte';
import { Follows } from './follows.svelte';
import { applyUpdate } from './stream-updates';
import { Planner } from './planner.svelte';
import { Preferences } from './preferences.svelte';
import { Runs } from './runs.svelte';
import { PendingRequests } from './pending-requests';
import { SteeringChannels, type SteeringChannel } from './steering-channels';
import { Tours } from './tours.svelte';
import { Virtuals } from './virtuals.svelte';
import { Zones } from './zones.svelte';

/** The context key; tests put a station of their own under it. */
export const STATION = Symbol('station');

const SESSION_ENDED =
  'This session has ended: after 12 hours, or because the account was changed or the stored data were restored.';

/** Pictures of each drone a second: what a page draws, and what a phone needs of the one that follows it. */
const RATES = { all: 5, one: 2 };

/** Everything that the page knows and can do; made once and handed down by context. */
export class Station {
  readonly rest = new RestClient();
  readonly clock = new CloudClock();
  readonly connection = new Connection();
  readonly fleet = new Fleet();
  readonly planner = new Planner();
  readonly commands = new Commands(this.#signed(), newUuid, (attempt) => {
    if (attempt.type === 'uploadMission') {
      this.planner.markUploaded(attempt.drone);
    }
  });
  readonly leases = new ControlLeases(this.rest.control);
  readonly view = new ViewState();
  readonly directory = new Directory(this.rest);
  readonly preferences = new Preferences();
  readonly zones = new Zones(this.rest.zones);
  readonly virtuals = new Virtuals(this.rest.virtuals);
  readonly tours = new Tours(this.rest.plans);
  readonly runs = new Runs(this.rest.runs);
  readonly follows = new Follows(this.rest.follows);
  readonly dispatches = new Dispatches(this.rest.dispatches);
  readonly recoveries = new Recoveries(this.rest.recoveries);
  /** undefined: not asked yet; null: nobody is signed in. */
  session = $state.raw<Session | null | undefined>(undefined);
  /** The reason for which the session ended, unless the user signed out. */
  signedOut = $state.raw<string | null>(null);
  settings = $state.raw<Settings | null>(null);
  selected = $derived<Drone | null>(this.fleet.find(this.view.selectedId));
  readonly #stream = new StreamClient(
    { address: () => this.#streamAddress(), open: (address) => openSocket(address), timers: systemTimers },
    {
      onMessage: (message) => this.#receive(message as StreamMessage),
      onUp: () => this.#streamUp(),
      onDown: () => this.#streamDown(),
      onRetryAt: (at) => (this.connection.retryAt = at),
      onUnauthorized: () => this.#forgetSession(SESSION_ENDED),
    },
  );

  #only: string | null = null;
  readonly #pending = new PendingRequests<Receipt>();
  readonly #steering = new SteeringChannels(
    (request) => this.#stream.send(request),
    (drone) => this.leases.held.get(drone),
  );

  /** Asks who is signed in. Rejects when the cloud cannot be reached. */
  async open(): Promise<void> {
    setInterval(() => {
      this.clock.refresh();
      this.connection.refresh();
      this.leases.sendHeartbeats();
    }, 1000);
    await this.resume();
  }

  async resume(): Promise<void> {
    try {
      await this.#enter(await this.rest.session());
    } catch (thrown) {
      if (thrown instanceof Problem && thrown.status === 401) {
        this.#forgetSession(thrown.sessionEnded ? thrown.message : null);
        return;
      }
      throw thrown;
    }
  }

  async signIn(name: string, password: string): Promise<void> {
    await this.#enter(await this.rest.signIn(name, password));
  }

  async changePassword(current: string, next: string): Promise<void> {
    await this.rest.changePassword(current, next);
    await this.#enter(await this.rest.session());
  }

  async signOut(): Promise<void> {
    await this.rest.signOut();
    this.#forgetSession(null);
  }

  async signOutEverywhere(): Promise<void> {
    await this.rest.signOutEverywhere();
    this.#forgetSession(null);
  }

  /** Opens a channel to steer that drone by; `onRefused` is called with the reason when the cloud refuses a setpoint. */
  steering(drone: string, onRefused: (why: string) => void): SteeringChannel {
    return this.#steering.open(drone, onRefused);
  }

  /** Over the stream, where it is up; else by a call of its own. */
  sendPositions(follow: string, positions: Positions): Promise<Receipt> {
    const request = { type: 'positions', follow, ...positions } as const;
    return (
      this.#pending.request((requestId) => this.#stream.send({ requestId, ...request })) ??
      this.rest.follows.positions(follow, positions)
    );
  }

  /** Subscribes to that drone alone, at a lower rate, so that little waits for a page that sleeps; null: to all. */
  subscribeTo(drone: string | null): void {
    if (drone !== this.#only) {
      this.#only = drone;
      this.#subscribe();
    }
  }

  #subscribe(): void {
    const only =
      this.#only === null ? { drones: null, rate: RATES.all } : { drones: [this.#only], rate: RATES.one };
    this.#stream.send({ type: 'subscribe', requestId: 'subscribe', ...only });
  }

  retryNow(): void {
    this.#stream.retryNow();
  }

  /** The reason for which no request can be sent now, or null. */
  get whyOffline(): string | null {
    return this.connection.stale ? 'No connection to the cloud.' : null;
  }

  /** Why this page cannot give that command now, or null; the cloud's own reasons come with each action. */
  whyNoCommand(drone: Drone, type: CommandKind): string | null {
    const supervisor = mayAct(this.session?.role, 'supervisor');
    return this.whyOffline ?? this.leases.whyNot(drone, type, this.session?.name, supervisor);
  }

  /** Commands under the control that this window keeps say so: they are refused when it has ended meanwhile. */
  #signed(): Pick<RestClient, 'sendCommand' | 'command' | 'commandsOf'> {
    return {
      sendCommand: (drone, request) => {
        const epoch = this.leases.held.get(drone);
        return this.rest.sendCommand(drone, epoch === undefined ? request : { ...request, epoch });
      },
      command: (id) => this.rest.command(id),
      commandsOf: (drone) => this.rest.commandsOf(drone),
    };
  }

  async #enter(session: Session): Promise<void> {
    this.#stream.stop();
    if (mayLook(session)) {
      this.settings = await this.rest.settings();
      this.connection.begin();
      this.#stream.start();
    }
    this.signedOut = null;
    this.session = session;
  }

  /** An administrator may have taken the right to look. */
  async #leaveIfShutOut(): Promise<void> {
    const session = await this.rest.session();
    if (!mayLook(session)) {
      await this.#enter(session);
    }
  }

  #forgetSession(why: string | null): void {
    this.#stream.stop();
    this.signedOut = why;
    this.session = null;
    const { directory, fleet, leases, zones, virtuals, tours, runs } = this;
    const operations = [this.follows, this.dispatches, this.recoveries];
    [directory, fleet, leases, zones, virtuals, tours, runs, ...operations].forEach((store) => store.clear());
    this.planner.stop();
    this.view.deselect();
    this.view.page = 'map';
  }

  #streamUp(): void {
    this.connection.up();
    this.#subscribe();
    void this.commands.catchUp();
    void this.zones.load();
    void this.virtuals.load();
    void this.tours.catchUp();
    void this.runs.catchUp();
    void this.follows.catchUp();
    void this.dispatches.catchUp();
    void this.recoveries.catchUp();
  }

  #streamDown(): void {
    this.connection.down();
    this.#pending.rejectAll();
  }

  /** An administrator may have given another one since the sign-in. */
  #roleIs(role: Role): void {
    if (this.session && this.session.role !== role) {
      this.session = { ...this.session, role };
    }
  }

  #receive(message: StreamMessage): void {
    this.connection.received();
    this.leases.sendHeartbeats();
    switch (message.type) {
      case 'hello':
        this.#roleIs(message.role);
        break;
      case 'drones':
        this.fleet.replaceAll(message.drones);
        break;
      case 'drone':
        this.fleet.update(message.drone);
        break;
      case 'droneRemoved':
        this.fleet.remove(message.id);
        break;
      case 'command':
        this.commands.apply(message.command);
        break;
      case 'positionsHeard':
        this.#pending.resolve(message.requestId, message.receipt);
        break;
      case 'ping':
        this.clock.synchronise(message.at);
        break;
      case 'error':
        if (this.#steering.reject(message) || this.#pending.reject(message)) {
          break;
        }
        console.warn('The stream reports:', message.problem.detail);
        break;
      default:
        applyUpdate(message, this);
        break;
    }
  }

  async #streamAddress(): Promise<string | null> {
    try {
      const { ticket } = await this.rest.streamTicket();
      return streamAddress(location, this.settings?.streamPort ?? 8081, { ticket, rate: RATES.all });
    } catch (thrown) {
      if (thrown instanceof Problem && thrown.status === 401) {
        return null;
      }
      if (thrown instanceof Problem && thrown.status === 403) {
        await this.#leaveIfShutOut();
      }
      throw thrown;
    }
  }
}

export function provideStation(station: Station): void {
  setContext(STATION, station);
}

export function useStation(): Station {
  return getContext<Station>(STATION);
}

/** Others receive nothing but their own session. */
function mayLook(session: Session): boolean {
  return !session.mustChangePassword && mayAct(session.role, 'viewer');
}
