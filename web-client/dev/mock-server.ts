// A development tool: plays the cloud's wire contract so that the page can be worked on without a server.
// Never shipped. `npm run mock`, then `DRONEMAP_SERVER=http://127.0.0.1:8090 npm run dev`.
// Signs in anybody with the password "flight-deck"; "first-password" asks for a new one. The user "viewer" is one.
import { randomUUID } from 'node:crypto';
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import { WebSocketServer, type WebSocket } from 'ws';
import type { AccessKey } from '../src/api/access-keys';
import type { Session } from '../src/api/accounts';
import type { Command, CommandRequest, SavedMission, StreamRequest } from '../src/api/types';
import { MockAccounts, type Handler } from './mock-accounts';
import { MockDrone } from './mock-drone';
import { MockFollows } from './mock-follows';
import { snapshotOf } from './mock-snapshot';

const port = Number(process.env['DRONEMAP_MOCK_PORT'] ?? 8090);
const streamPort = port + 1;
const count = Number(process.env['DRONEMAP_MOCK_DRONES'] ?? 4);

const drones = Array.from({ length: count }, (_, i) => {
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
});
const commands: Command[] = [];
const clients = new Set<WebSocket>();
let session: Session | null = null;
const accounts = new MockAccounts();
let keys: AccessKey[] = [];
let missions: SavedMission[] = [];

class Refusal extends Error {
  constructor(
    readonly status: number,
    readonly detail: string,
    readonly extra: Record<string, unknown> = {},
  ) {
    super(detail);
  }
}

function broadcast(message: unknown): void {
  const text = JSON.stringify(message);
  clients.forEach((client) => client.send(text));
}

const follows = new MockFollows({
  drones,
  owner: () => session?.name ?? 'nobody',
  broadcast,
  refusal: (status, detail) => new Refusal(status, detail),
});

function droneOf(id: string): MockDrone {
  const drone = drones.find((one) => one.beginning.id === id);
  if (drone === undefined) {
    throw new Refusal(404, `There is no drone ${id}.`);
  }
  return drone;
}

function command(drone: MockDrone, request: CommandRequest & { id?: string }): Command {
  let record: Command = {
    id: request.id ?? randomUUID(),
    drone: drone.beginning.id,
    by: session?.name ?? 'nobody',
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
  const put = (change: Partial<Command>): void => {
    record = { ...record, ...change };
    const at = commands.findIndex((one) => one.id === record.id);
    commands.splice(Math.max(at, 0), at < 0 ? 0 : 1, record);
    broadcast({ type: 'command', command: record });
  };
  const why = drone.why(request.type);
  if (why !== null) {
    const finishedAt = new Date().toISOString();
    const outcome = { result: 'refused', by: 'gate', reason: why, code: 'command-refused' } as const;
    put({ phase: 'done', outcome, finishedAt });
    throw new Refusal(409, why, { commandId: record.id });
  }
  put({});
  setTimeout(
    () =>
      put({
        phase: 'accepted',
        progress: request.type === 'uploadMission' ? { done: 1, total: request.items.length } : null,
      }),
    250,
  );
  setTimeout(
    () => put({ phase: 'done', outcome: drone.act(request), finishedAt: new Date().toISOString() }),
    900,
  );
  return record;
}

function signIn(body: { name: string; password: string }): Session {
  if (!['flight-deck', 'first-password'].includes(body.password)) {
    throw new Refusal(401, 'The user name or the password is wrong.');
  }
  session = {
    name: body.name,
    role: body.name === 'viewer' ? 'viewer' : 'administrator',
    mustChangePassword: body.password === 'first-password',
    organisation: null,
  };
  return session;
}

function changePassword(body: { next: string }): void {
  if (body.next.length < 10) {
    throw new Refusal(422, 'The new password is too short.', {
      field: 'next',
      allowed: '10 characters or more',
    });
  }
  session = session && { ...session, mustChangePassword: false };
}

function newKey(given: Record<string, unknown>): AccessKey {
  const days = given['days'] as number | undefined;
  return {
    id: randomUUID(),
    label: String(given['label']),
    role: session?.role ?? 'viewer',
    operations: given['operations'] as AccessKey['operations'],
    drones: (given['drones'] as string[] | undefined) ?? null,
    area: (given['area'] as AccessKey['area'] | undefined) ?? null,
    floor: (given['floor'] as number | undefined) ?? null,
    ceiling: (given['ceiling'] as number | undefined) ?? null,
    altitudeReference: (given['altitudeReference'] as AccessKey['altitudeReference'] | undefined) ?? null,
    expiresAt: days === undefined ? null : new Date(Date.now() + days * 86_400_000).toISOString(),
    parent: null,
    createdAt: new Date().toISOString(),
    lastUsedAt: null,
    key: null,
  };
}

function needSession(): Session {
  if (session === null) {
    throw new Refusal(401, 'Sign in first.');
  }
  return session;
}

const HANDLERS: Record<string, Handler> = {
  'POST session': (body) => signIn(body),
  'GET session': () => needSession(),
  'DELETE session': () => {
    session = null;
  },
  'POST session/*': (body) => changePassword(body),
  'POST access-keys/*/renew': (_, id) => ({
    ...keys.find((key) => key.id === id),
    key: `dmk_${randomUUID().replaceAll('-', '')}`,
  }),
  ...accounts.handlers,
  ...follows.handlers,
  'GET settings': () => ({
    streamPort,
    tileAddress: process.env['DRONEMAP_TILES'] ?? null,
    version: 'mock',
    publicMode: false,
  }),
  'POST stream-tickets': () => needSession() && { ticket: randomUUID() },
  'POST drones/*/commands': (body, id) => command(droneOf(id), body),
  'GET drones/*/commands': (_, id) => ({ commands: commands.filter((one) => one.drone === id) }),
  'GET commands/*': (_, id) => commands.find((one) => one.id === id),
};

function route(method: string, path: string, body: unknown): unknown {
  const [, first = '', second = '', third = ''] = path.split('/');
  const handler = HANDLERS[`${method} ${first}${second ? '/*' : ''}${third ? `/${third}` : ''}`];
  return handler === undefined ? routeLists(method, first, second, body) : handler(body as never, second);
}

function routeLists(method: string, list: string, id: string, body: unknown): unknown {
  const given = body as Record<string, unknown>;
  switch (`${method} ${list}`) {
    case 'GET access-keys':
      return { accessKeys: keys };
    case 'POST access-keys': {
      const made = newKey(given);
      keys = [...keys, made];
      return { ...made, key: `dmk_${randomUUID().replaceAll('-', '')}` };
    }
    case 'DELETE access-keys':
      keys = keys.filter((key) => key.id !== id);
      return undefined;
    case 'GET missions':
      return { missions };
    case 'POST missions': {
      const saved = {
        id: randomUUID(),
        by: session?.name ?? '',
        changedAt: new Date().toISOString(),
        ...given,
      };
      missions = [...missions, saved as unknown as SavedMission];
      return saved;
    }
    case 'DELETE missions':
      missions = missions.filter((mission) => mission.id !== id);
      return undefined;
    default:
      throw new Refusal(404, `There is nothing at ${list}.`);
  }
}

function hearPhone(client: WebSocket, said: Extract<StreamRequest, { type: 'positions' }>): void {
  const { requestId } = said;
  try {
    client.send(
      JSON.stringify({ type: 'positionsHeard', requestId, receipt: follows.hear(said.follow, said) }),
    );
  } catch (thrown) {
    const { status, detail } = thrown instanceof Refusal ? thrown : new Refusal(500, String(thrown));
    client.send(JSON.stringify({ type: 'error', requestId, problem: { status, detail } }));
  }
}

async function bodyOf(request: IncomingMessage): Promise<unknown> {
  const chunks: Buffer[] = [];
  for await (const chunk of request) {
    chunks.push(chunk as Buffer);
  }
  const text = Buffer.concat(chunks).toString();
  return text === '' ? null : JSON.parse(text);
}

async function answer(request: IncomingMessage, response: ServerResponse): Promise<void> {
  const path = decodeURIComponent((request.url ?? '').replace(/^\/api\/v1/, '').replace(/\?.*/, ''));
  try {
    const result = route(request.method ?? 'GET', path, await bodyOf(request));
    response.writeHead(result === undefined ? 204 : 200, { 'Content-Type': 'application/json' });
    response.end(result === undefined ? '' : JSON.stringify(result));
  } catch (thrown) {
    const refusal = thrown instanceof Refusal ? thrown : new Refusal(500, String(thrown));
    response.writeHead(refusal.status, { 'Content-Type': 'application/problem+json' });
    response.end(JSON.stringify({ status: refusal.status, detail: refusal.detail, ...refusal.extra }));
  }
}

createServer((request, response) => void answer(request, response)).listen(port, '127.0.0.1', () =>
  console.log(`Mock cloud on http://127.0.0.1:${port}, stream on ${streamPort}`),
);
new WebSocketServer({ port: streamPort, host: '127.0.0.1' }).on('connection', (client) => {
  clients.add(client);
  let isPhone = false;
  client.on('close', () => {
    clients.delete(client);
    if (isPhone) {
      follows.left();
    }
  });
  client.on('message', (data: Buffer) => {
    const said = JSON.parse(data.toString()) as StreamRequest;
    if (said.type === 'positions') {
      isPhone = true;
      hearPhone(client, said);
    }
  });
  client.send(JSON.stringify({ type: 'hello', user: session?.name ?? '', role: session?.role ?? 'viewer' }));
  client.send(JSON.stringify({ type: 'drones', drones: drones.map((drone) => snapshotOf(drone)) }));
  follows.underWay.forEach((follow) => client.send(JSON.stringify({ type: 'follow', follow })));
});
setInterval(() => {
  drones.forEach((drone) => {
    drone.step(0.25);
    broadcast({ type: 'drone', drone: snapshotOf(drone) });
  });
  follows.step();
}, 250);
setInterval(() => broadcast({ type: 'ping', at: new Date().toISOString() }), 5000);

// One drone falls silent and comes back, for the eyes.
if (process.env['DRONEMAP_MOCK_SILENT'] === '1' && drones[1] !== undefined) {
  drones[1].silentSince = Date.now();
}
