import { once } from 'node:events';
import { createServer, type IncomingMessage, type Server, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { WebSocketServer, type WebSocket } from 'ws';
import type {
  CommandView,
  ControlView,
  DroneView,
  StreamMessage,
  StreamRequest,
} from '../contract/schemas.js';
import { PING_MILLISECONDS } from './quick-timers.js';

export const KEY = 'a key';
const TICKET = 'a-ticket';
const HOST = '127.0.0.1';

/** What a request is answered with in place of its answer: a problem, or nothing at all on a line that breaks. */
export type Fault = { readonly status: number; readonly problem: object } | 'answer lost' | 'request lost';

interface Asked {
  /** Such as POST /api/v1/drones/d1/commands. */
  readonly what: string;
  readonly body: Record<string, unknown>;
}

/** A drone on the ground; of its members those that a client reads. */
export function aDrone(change: Partial<DroneView> = {}): DroneView {
  const drone = { id: 'd1', name: 'Copter 1', armed: false, flight: 'onGround', mode: 'GUIDED', version: 1 };
  return { ...drone, ...change } as DroneView;
}

/** Plays what a client needs of REST and the stream on real sockets; commands and drones do what the test says. */
export class FakeServer {
  readonly asked: Asked[] = [];
  readonly heard: StreamRequest[] = [];
  readonly commands = new Map<string, CommandView>();
  readonly drones = new Map([['d1', aDrone()]]);
  /** Called when a command is given for the first time. */
  onGiven: (command: CommandView) => void = () => undefined;
  /** Of the next requests of that kind, one for each. */
  readonly faults = new Map<string, Fault[]>();
  control: ControlView = {
    state: 'free',
    holder: null,
    explicit: false,
    since: null,
    epoch: 0,
    requests: [],
  };
  connections = 0;
  /** The one that is known. */
  key = KEY;
  readonly #http: Server;
  readonly #sockets: WebSocketServer;
  readonly #ready = new Set<WebSocket>();
  readonly #pings: NodeJS.Timeout;

  private constructor(http: Server, sockets: WebSocketServer) {
    this.#http = http;
    this.#sockets = sockets;
    http.on('request', (request, response) => void this.#serve(request, response));
    sockets.on('connection', (socket, { url = '' }) => this.#accept(socket, url));
    this.#pings = setInterval(
      () => this.say({ type: 'ping', at: '2026-01-01T12:00:00Z' }),
      PING_MILLISECONDS,
    );
  }

  static async start(): Promise<FakeServer> {
    const http = createServer().listen(0, HOST);
    const sockets = new WebSocketServer({ port: 0, host: HOST });
    await Promise.all([once(http, 'listening'), once(sockets, 'listening')]);
    return new FakeServer(http, sockets);
  }

  get url(): string {
    return `http://${HOST}:${(this.#http.address() as AddressInfo).port}`;
  }

  get listeners(): number {
    return this.#ready.size;
  }

  say(message: StreamMessage | { readonly type: string }): void {
    this.#ready.forEach((socket) => socket.send(JSON.stringify(message)));
  }

  setDrone(change: Partial<DroneView>): void {
    const before = this.drones.get(change.id ?? 'd1');
    const drone = aDrone({ ...before, version: (before?.version ?? 0) + 1, ...change });
    this.drones.set(drone.id, drone);
    this.say({ type: 'drone', drone });
  }

  /** Ends a command, or brings it to another phase. */
  setCommand(id: string, change: Partial<CommandView>): void {
    const command = { ...this.commands.get(id), ...change } as CommandView;
    this.commands.set(id, command);
    this.say({ type: 'command', command });
  }

  breakLines(): void {
    this.#sockets.clients.forEach((socket) => socket.terminate());
  }

  countOf(what: string): number {
    return this.asked.filter((one) => one.what === what).length;
  }

  async close(): Promise<void> {
    clearInterval(this.#pings);
    this.breakLines();
    this.#http.closeAllConnections();
    const closed = [once(this.#http, 'close'), once(this.#sockets, 'close')];
    this.#http.close();
    this.#sockets.close();
    await Promise.all(closed);
  }

  #accept(socket: WebSocket, address: string): void {
    this.connections += 1;
    if (address.includes(`ticket=${TICKET}&`)) {
      this.#greet(socket, this.key);
    }
    socket.on('close', () => this.#ready.delete(socket));
    socket.on('message', (data: Buffer) => {
      const request = JSON.parse(data.toString()) as StreamRequest;
      this.heard.push(request);
      if (request.type === 'authenticate') {
        this.#greet(socket, request.key);
      }
    });
  }

  #greet(socket: WebSocket, key: string): void {
    if (key !== this.key) {
      const problem = { status: 401, code: 'key-unknown', detail: 'This access key is none.' };
      socket.send(JSON.stringify({ type: 'error', problem }));
      socket.close();
      return;
    }
    socket.send(JSON.stringify({ type: 'hello', user: 'olga', role: 'operator', version: '0.1.0' }));
    socket.send(JSON.stringify({ type: 'drones', drones: [...this.drones.values()] }));
    this.#ready.add(socket);
  }

  async #serve(request: IncomingMessage, response: ServerResponse): Promise<void> {
    const chunks: Buffer[] = [];
    for await (const chunk of request) {
      chunks.push(chunk as Buffer);
    }
    const text = Buffer.concat(chunks).toString();
    const body = (text === '' ? {} : JSON.parse(text)) as Record<string, unknown>;
    const what = `${request.method ?? ''} ${request.url ?? ''}`;
    this.asked.push({ what, body });
    const fault = this.faults.get(what)?.shift();
    if (fault === 'request lost') {
      request.socket.destroy();
      return;
    }
    const { authorization, 'x-dronemap': fromPage } = request.headers;
    const isKnown = fromPage === '1' || authorization === `Bearer ${this.key}`;
    const [status, answer] =
      typeof fault === 'object'
        ? [fault.status, fault.problem]
        : isKnown
          ? this.#answer(what, body)
          : [401, { code: 'key-unknown', detail: 'This access key is none.' }];
    if (fault === 'answer lost') {
      request.socket.destroy();
      return;
    }
    response.writeHead(status, { 'Content-Type': 'application/json', 'Dronemap-Version': '0.1.0' });
    response.end(JSON.stringify(answer));
  }

  #answer(what: string, body: Record<string, unknown>): [number, unknown] {
    const [, drone = '', action = ''] = /\/drones\/([^/]+)(.*)$/.exec(what) ?? [];
    if (action.startsWith('/control')) {
      return this.#control(action, what);
    }
    if (what === `POST /api/v1/drones/${drone}/commands`) {
      return this.#judged(drone, body);
    }
    if (what === `GET /api/v1/drones/${drone}`) {
      return found(this.drones.get(drone), 'drone-unknown');
    }
    if (what.startsWith('GET /api/v1/commands/')) {
      return found(this.commands.get(what.split('/').at(-1) ?? ''), 'command-unknown');
    }
    const [path = '', query = ''] = what.split('?');
    return found(this.#whatIsThere[path]?.(new URLSearchParams(query)), 'address-unknown');
  }

  /** Answers how events are followed: told the query. */
  followed: (query: URLSearchParams) => object = () => ({ events: [], gaps: [], next: 'now' });

  readonly #whatIsThere: Readonly<Record<string, (query: URLSearchParams) => object>> = {
    'GET /api/v1/events': (query) => this.followed(query),
    'GET /api/v1/session': () => ({ name: 'olga', role: 'operator', organisation: null }),
    'GET /api/v1/settings': () => ({ streamPort: (this.#sockets.address() as AddressInfo).port }),
    'GET /api/v1/drones': () => ({ drones: [...this.drones.values()] }),
    'POST /api/v1/stream-tickets': () => ({ ticket: TICKET }),
  };

  /** Refuses a command that names another control than there is, or comes while somebody else has it. */
  #judged(drone: string, body: Record<string, unknown>): [number, unknown] {
    const { holder, epoch } = this.control;
    const refused = (code: string): [number, unknown] => [409, { code, commandId: body['id'], detail: code }];
    if ('epoch' in body && body['epoch'] !== epoch) {
      return refused('control-ended');
    }
    return holder === null || holder === 'olga' ? [202, this.#give(drone, body)] : refused('control-held');
  }

  #give(drone: string, body: Record<string, unknown>): CommandView {
    const id = String(body['id']);
    const known = this.commands.get(id);
    if (known !== undefined) {
      return known;
    }
    const { type, epoch = null } = body;
    const command = {
      id,
      drone,
      type,
      epoch,
      summary: String(type),
      phase: 'sent',
      outcome: null,
      warnings: [],
    };
    this.commands.set(id, command as unknown as CommandView);
    this.onGiven(command as unknown as CommandView);
    return this.commands.get(id) as CommandView;
  }

  #control(action: string, what: string): [number, unknown] {
    if (action === '/control/take') {
      this.control = { ...this.control, state: 'held', holder: 'olga', epoch: this.control.epoch + 1 };
    } else if (what.startsWith('DELETE')) {
      this.control = { ...this.control, state: 'free', holder: null };
    } else if (this.control.holder !== 'olga') {
      return [409, { code: 'control-not-held', detail: 'Mia has control.', status: 409 }];
    }
    return [200, this.control];
  }
}

function found(thing: object | undefined, code: string): [number, unknown] {
  return thing === undefined ? [404, { code, detail: 'There is no such thing.' }] : [200, thing];
}
