/** The state of the mock server: what drones, commands, accounts, keys, missions and follows it plays, and how. */
import { randomUUID } from 'node:crypto';
import type { MissionRequest, StreamTicket } from '@dronemap/client';
import type { StreamRequest } from '@dronemap/client';
import type { Command, CommandRequest, SavedMission, Settings } from '../src/api/types';
import { MockAccounts } from './mock-accounts';
import { MockDrone } from './mock-drone';
import { MockFollows } from './mock-follows';
import { MockKeys } from './mock-keys';
import { WithStatus, type Handler } from './mock-rest';
import { snapshotOf } from './mock-snapshot';
import { MockZones } from './mock-zones';
import { needed, Refusal } from './refusal';

const STEP_SECONDS = 0.25;

export interface CloudOptions {
  /** How many drones there are. */
  readonly drones: number;
  /** Where tiles of maps are; null: nowhere. */
  readonly tileAddress: string | null;
  readonly streamPort: () => number;
  /** Sends a message to all on the stream. */
  readonly broadcast: (message: unknown) => void;
}

export class MockCloud {
  readonly accounts = new MockAccounts();
  readonly drones: readonly MockDrone[];
  readonly #follows: MockFollows;
  readonly #zones: MockZones;
  readonly #keys = new MockKeys(() => this.accounts.role);
  readonly #options: CloudOptions;
  readonly #timers = new Set<NodeJS.Timeout>();
  #commands: Command[] = [];
  #missions: SavedMission[] = [];

  constructor(options: CloudOptions) {
    this.#options = options;
    this.drones = Array.from({ length: options.drones }, (_, i) => droneAt(i));
    const ports = { owner: (): string => this.accounts.name, broadcast: options.broadcast };
    this.#follows = new MockFollows({ drones: this.drones, ...ports });
    this.#zones = new MockZones(ports);
  }

  get handlers(): Record<string, Handler> {
    return {
      ...this.accounts.handlers,
      ...this.#keys.handlers,
      ...this.#follows.handlers,
      ...this.#zones.handlers,
      ...this.#own,
    };
  }

  readonly #own: Record<string, Handler> = {
    getSettings: () =>
      ({
        streamPort: this.#options.streamPort(),
        tileAddress: this.#options.tileAddress,
        version: 'mock',
        publicMode: false,
        phonePage: null,
      }) satisfies Settings,
    makeStreamTicket: () => ({ ticket: randomUUID() }) satisfies StreamTicket,
    listDrones: () => ({ drones: this.drones.map((drone) => snapshotOf(drone)) }),
    getDrone: (_, id) => snapshotOf(this.#drone(id)),
    giveCommand: (body: CommandRequest & { id?: string | null }, id) =>
      new WithStatus(202, this.#command(this.#drone(id), body)),
    listCommands: (_, id) => ({ commands: this.#commands.filter((one) => one.drone === id) }),
    getCommand: (_, id) => {
      const found = this.#commands.find((one) => one.id === id);
      if (found === undefined) {
        const more = { parameters: { command: id } };
        throw new Refusal(404, 'command-unknown', `There is no command ${id}.`, more);
      }
      return found;
    },
    listMissions: () => ({ missions: this.#missions }),
    addMission: ({ name, items }: MissionRequest) => {
      const saved = {
        id: randomUUID(),
        name: needed(name, 'name', '1 to 80 characters'),
        items: needed(items, 'items', '1 to 500 items') as SavedMission['items'],
        by: this.accounts.name,
        changedAt: new Date().toISOString(),
      };
      this.#missions = [...this.#missions, saved];
      return saved;
    },
    deleteMission: (_, id) => {
      this.#missions = this.#missions.filter((mission) => mission.id !== id);
    },
  };

  /** The first messages on a stream. */
  greeting(): object[] {
    const { name, role } = this.accounts;
    return [
      { type: 'hello', user: name, role, version: 'development' },
      { type: 'drones', drones: this.drones.map((drone) => snapshotOf(drone)) },
      ...this.#follows.underWay.map((follow) => ({ type: 'follow', follow })),
    ];
  }

  /** The answer to a request on the stream; undefined: there is none here. */
  answer(request: StreamRequest): object | undefined {
    switch (request.type) {
      case 'positions':
        return {
          type: 'positionsHeard',
          requestId: null,
          receipt: this.#follows.receive(request.follow, request),
        };
      case 'command': {
        const command = this.#command(this.#drone(request.drone), request.command as CommandRequest);
        return { type: 'commandAccepted', requestId: null, command };
      }
      default:
        return undefined;
    }
  }

  phoneLeft(): void {
    this.#follows.left();
  }

  /** Time goes on, in steps of a quarter of a second, until `close`. */
  run(): void {
    this.#timers.add(setInterval(() => this.#step(), STEP_SECONDS * 1000));
    this.#timers.add(
      setInterval(() => this.#options.broadcast({ type: 'ping', at: new Date().toISOString() }), 1000),
    );
  }

  close(): void {
    this.#timers.forEach((timer) => clearInterval(timer));
  }

  #step(): void {
    this.drones.forEach((drone) => {
      drone.step(STEP_SECONDS);
      this.#options.broadcast({ type: 'drone', drone: snapshotOf(drone) });
    });
    this.#follows.step();
  }

  #drone(id: string): MockDrone {
    const drone = this.drones.find((one) => one.beginning.id === id);
    if (drone === undefined) {
      throw new Refusal(404, 'drone-unknown', `There is no drone ${id}.`, { parameters: { drone: id } });
    }
    return drone;
  }

  #command(drone: MockDrone, request: CommandRequest & { id?: string | null }): Command {
    const sent: Command = {
      id: request.id ?? randomUUID(),
      drone: drone.beginning.id,
      by: this.accounts.name,
      face: 'rest',
      type: request.type,
      summary: 'altitude' in request ? `${request.type} to ${request.altitude} m` : request.type,
      at: new Date().toISOString(),
      phase: 'sent',
      outcome: null,
      finishedAt: null,
      progress: null,
      epoch: null,
      warnings: [],
    };
    const reason = drone.why(request.type);
    if (reason !== null) {
      const outcome = { result: 'refused', by: 'gate', reason, code: 'command-refused' } as const;
      this.#put({ ...sent, phase: 'done', outcome, finishedAt: new Date().toISOString() });
      throw new Refusal(409, 'command-refused', reason, { commandId: sent.id });
    }
    this.#put(sent);
    const progress = request.type === 'uploadMission' ? { done: 1, total: request.items.length } : null;
    this.#later(250, () => this.#put({ ...sent, phase: 'accepted', progress }));
    this.#later(900, () => {
      const outcome = drone.act(request);
      this.#put({ ...sent, phase: 'done', progress, outcome, finishedAt: new Date().toISOString() });
    });
    return sent;
  }

  #put(command: Command): void {
    this.#commands = [...this.#commands.filter(({ id }) => id !== command.id), command];
    this.#options.broadcast({ type: 'command', command });
  }

  #later(milliseconds: number, act: () => void): void {
    this.#timers.add(setTimeout(act, milliseconds));
  }
}

function droneAt(i: number): MockDrone {
  const rover = i === 3;
  return new MockDrone({
    id: `d${i + 1}k2m9q4xa`,
    name: rover ? 'Flight log 12' : `Copter ${i + 1}`,
    kind: rover ? 'rover' : 'multicopter',
    vehicle: rover ? 'ArduRover' : 'ArduCopter',
    port: 14601 + i,
    latitude: 47.3977 + (i % 10) * 0.0012,
    longitude: 8.5456 + Math.floor(i / 10) * 0.002 + (i % 3) * 0.0016,
    place: '2 km NE of Zürich, CH',
    replay: rover,
  });
}
