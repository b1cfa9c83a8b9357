import { once } from 'node:events';
import { Ajv2020 } from 'ajv/dist/2020.js';
import formats from 'ajv-formats';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { WebSocket } from 'ws';
import { named, operationsOf, readRest, readStream, type Operation } from './description';
import { listen, type Listener } from './mock-listener';
import { Schemas } from './schemas';

/** Milliseconds for what walks the whole description, on a machine that does much else. */
const PATIENCE = 60_000;
const SIGN_IN = { name: 'admin', password: 'flight-deck' };
const DRONE = 'd1k2m9q4xa';
/** What stands in addresses where nothing was made before: any name will do for an example. */
const IN_PATH: Readonly<Record<string, string>> = { '/api/v1/drones': DRONE, '/api/v1/users': 'ann' };
/** What the scenario refuses after the follow was cancelled. */
const REFUSED = ['startFollow', 'pauseFollow', 'continueFollow', 'stopFollow', 'reportFollowPositions'];
const BODIES: Readonly<Record<string, unknown>> = {
  signIn: SIGN_IN,
  giveCommand: { type: 'arm', id: 'a-command' },
};

interface Answered {
  status: number;
  type: string;
  body: unknown;
}

const breaches: string[] = [];
let mock: Listener;

beforeAll(async () => {
  const breach = (sentence: string): unknown => breaches.push(sentence);
  mock = await listen({ port: 0, streamPort: 0, drones: 4, tileAddress: null, breach });
});

afterAll(() => mock.close());

async function call(
  method: string,
  path: string,
  body?: string,
  kind = 'application/json',
): Promise<Answered> {
  const init = body === undefined ? {} : { body, headers: { 'Content-Type': kind } };
  const response = await fetch(mock.address + path, { method, redirect: 'manual', ...init });
  const type = response.headers.get('content-type') ?? '';
  const text = await response.text();
  return {
    status: response.status,
    type,
    body: type.endsWith('json') && text !== 'string' ? JSON.parse(text) : text,
  };
}

async function signedIn(): Promise<void> {
  if (mock.cloud.accounts.session === null) {
    await call('POST', '/api/v1/session', JSON.stringify(SIGN_IN));
  }
}

/** The address of an operation, with what was made before. */
function addressOf({ path, parameters = [] }: Operation, made: ReadonlyMap<string, string>): string {
  return path.replaceAll(/\{(\w+)\}/g, (_, name: string, at: number) => {
    const before = path.slice(0, at - 1);
    const isNumber = parameters.find((one) => one.name === name)?.schema['type'] === 'integer';
    return made.get(before) ?? IN_PATH[before] ?? (isNumber ? '1' : 'x1');
  });
}

/** Each address is walked from making to deleting. */
function inOrder(operations: readonly Operation[]): Operation[] {
  const rank = ({ method, responses }: Operation): number =>
    method === 'DELETE' ? 2 : '201' in responses || method === 'POST' ? 0 : 1;
  return operations.toSorted((one, other) => rank(one) - rank(other));
}

describe('the mock server plays the description of REST', () => {
  const description = readRest();
  const operations = operationsOf(description);
  const ajv = new Ajv2020({ strict: false, validateSchema: false });
  formats.default(ajv);
  ajv.addSchema(description, 'rest');

  /** By the description as it stands, apart from what the mock server makes of it. */
  function faultOf({ method, path, responses }: Operation, { status, type, body }: Answered): string | null {
    const response = responses[String(status)];
    if (response === undefined) {
      return 'the status is not listed';
    }
    if (response.content === undefined) {
      return body === '' ? null : 'there is a body';
    }
    const steps = ['paths', path, method.toLowerCase(), 'responses', status, 'content', type, 'schema'];
    const pointer = steps.map((step) => encodeURIComponent(String(step).replaceAll('/', '~1'))).join('/');
    const check = ajv.getSchema(`rest#/${pointer}`);
    return check?.(body) === true ? null : ajv.errorsText(check?.errors) || 'the type is not listed';
  }

  /** Calls an operation with an example, and remembers what that makes. */
  async function example(operation: Operation, made: Map<string, string>): Promise<Answered> {
    const { operationId, method, path, requestBody } = operation;
    const [kind] = Object.keys(requestBody?.content ?? {});
    const body = BODIES[operationId] ?? mock.rest.exampleFor(operation) ?? 'text';
    const text = typeof body === 'string' ? body : JSON.stringify(body);
    const answered = await call(
      method,
      addressOf(operation, made),
      ...(kind === undefined ? [] : [text, kind]),
    );
    const { id } = answered.body as { id?: string };
    if (id !== undefined && method === 'POST') {
      made.set(operationId === 'giveCommand' ? '/api/v1/commands' : path, id);
    }
    return answered;
  }

  it(
    'answers each operation as it is described',
    async () => {
      const made = new Map<string, string>();
      const wrong: string[] = [];
      for (const operation of inOrder(operations)) {
        await signedIn();
        const answered = await example(operation, made);
        const fault = faultOf(operation, answered);
        const isRefused = answered.status >= 400;
        if (fault !== null || isRefused !== REFUSED.includes(operation.operationId)) {
          wrong.push(`${operation.operationId} ${fault ?? ''} ${JSON.stringify(answered)}`);
        }
      }
      expect(wrong).toEqual([]);
      expect(breaches).toEqual([]);
    },
    PATIENCE,
  );

  it(
    'refuses each body that is not as it is described',
    async () => {
      const taken: string[] = [];
      for (const operation of operations.filter(
        ({ requestBody }) => requestBody?.content['application/json'],
      )) {
        await signedIn();
        const { method, operationId } = operation;
        const address = addressOf(operation, new Map());
        const statuses = [
          (await call(method, address, '{"noSuchMember": 1}')).status,
          (await call(method, address, '{"name": ')).status,
          (await call(method, address, '[]')).status,
          (await call(method, address, '{}', 'text/csv')).status,
        ];
        if (statuses.join(' ') !== '422 400 400 415') {
          taken.push(`${operationId}: ${statuses.join(' ')}`);
        }
      }
      expect(taken).toEqual([]);
      expect(breaches).toEqual([]);
    },
    PATIENCE,
  );

  it('plays a follow', async () => {
    await signedIn();
    const order = '{"name": "Along the shore", "latitude": 47.4, "longitude": 8.5}';
    const { body } = await call('POST', '/api/v1/follows', order);
    const { id } = body as { id: string };
    expect(await call('POST', `/api/v1/follows/${id}/pause`)).toMatchObject({ status: 409 });
    expect(await call('POST', `/api/v1/follows/${id}/start`)).toMatchObject({
      status: 200,
      body: { name: 'Along the shore', state: 'starting', owner: 'admin' },
    });
    const at = new Date().toISOString();
    const positions = JSON.stringify({ sent: at, positions: [{ at, latitude: 47.4, longitude: 8.5 }] });
    expect(await call('POST', `/api/v1/follows/${id}/positions`, positions)).toMatchObject({
      status: 200,
      body: { follow: id, taken: 1 },
    });
    expect(await call('POST', `/api/v1/follows/${id}/stop`)).toMatchObject({ body: { state: 'returning' } });
    expect(breaches).toEqual([]);
  });

  it.each([
    ['{"type": "arm", "hight": 5}', 'There is no member "hight" here; there are: epoch, id, type.'],
    ['{"type": "takeOff"}', '"altitude" is missing; it must be 1 to 500.'],
    ['{"type": "takeOff", "altitude": 600}', '"altitude" must be 1 to 500, not 600.'],
    ['{"type": "takeOff", "altitude": "high"}', '"altitude" must be a number.'],
    ['{"type": "jump"}', '"type" must be one of its forms, not "jump".'],
  ])('says what is wrong with %s', async (body, detail) => {
    await signedIn();
    const answered = await call('POST', `/api/v1/drones/${DRONE}/commands`, body);
    expect(answered).toMatchObject({ status: 422, type: 'application/problem+json', body: { detail } });
  });

  it('refuses a value in the address that is not as it is described', async () => {
    await signedIn();
    const { status, body } = await call(
      'POST',
      `/api/v1/drones/${DRONE}/commands?wait=long`,
      '{"type": "hold"}',
    );
    expect([status, body]).toEqual([
      422,
      expect.objectContaining({ field: 'wait', detail: '"wait" must be a number.' }),
    ]);
    expect(await call('POST', `/api/v1/drones/${DRONE}/logs/first/download`)).toMatchObject({ status: 422 });
  });

  it('has nothing but what is described', async () => {
    expect(await call('GET', '/api/v1/drone')).toMatchObject({
      status: 404,
      body: {
        code: 'address-unknown',
        detail: 'There is nothing at /api/v1/drone; /api/docs lists the addresses.',
      },
    });
    expect(await call('PUT', '/api/v1/users')).toMatchObject({
      status: 405,
      body: { code: 'method-not-taken', detail: 'This address does not take PUT; it takes GET, POST.' },
    });
  });

  it('lets nobody see anything before signing in', async () => {
    await signedIn();
    await call('DELETE', '/api/v1/session');
    expect(await call('GET', '/api/v1/drones')).toMatchObject({
      status: 401,
      body: { code: 'sign-in-needed' },
    });
  });
});

describe('the mock server plays the description of the stream', () => {
  const { operations } = readStream();
  const schemas = new Schemas(readStream());
  const asked = Object.entries(operations).filter(([, { action }]) => action === 'receive');

  /** Sent to all clients without a request. */
  const UNSOLICITED = ['drone', 'drones', 'ping', 'command', 'follow', 'followNow'];

  interface Received {
    type: string;
    requestId?: string;
    problem?: object;
  }

  /** What a request is answered with; null: nothing before the next request is answered. */
  async function answerTo(request: object): Promise<Received | null> {
    const client = new WebSocket(mock.streamAddress);
    const answers: Received[] = [];
    const answered = new Promise<void>((resolve) => {
      client.on('message', (data: Buffer) => {
        const received = JSON.parse(data.toString()) as Received;
        if (!UNSOLICITED.includes(received.type)) {
          answers.push(received);
        }
        if (received.type === 'error' && received.requestId === 'next') {
          resolve();
        }
      });
    });
    await once(client, 'open');
    client.send(JSON.stringify({ ...request, requestId: 'mine' }));
    client.send(JSON.stringify({ type: 'none', requestId: 'next' }));
    await answered;
    client.close();
    const [greeting, ...others] = answers.slice(0, -1);
    expect(greeting?.type).toBe('hello');
    expect(others.length).toBeLessThanOrEqual(1);
    return others[0] ?? null;
  }

  it.each(asked)('answers %s as it is described', async (type, { messages, reply }) => {
    const nameOf = ({ $ref }: { $ref: string }): string => $ref.split('/').at(-1) ?? '';
    const [request] = messages.map((message) => schemas.example(named(nameOf(message))) as object);
    const answer = await answerTo({
      ...request,
      ...(type === 'command' ? { drone: 'd2k2m9q4xa', command: { type: 'arm' } } : {}),
    });
    const [first] = (reply?.messages ?? []).map(nameOf).filter((name) => name !== 'StreamError');
    // There is no follow that is under way.
    const expected = type === 'positions' ? 'StreamError' : first;
    expect(expected === undefined ? answer : schemas.faultOf(named(expected), answer)).toBeNull();
    expect(breaches).toEqual([]);
  });

  it.each([
    [{ type: 'subscribe', rate: 'often' }, '"rate" must be a whole number.'],
    [
      { type: 'control', drone: 'd2k2m9q4xa', action: 'take', user: 'ann' },
      'There is no member "user" here; there are: action, drone, requestId, type.',
    ],
  ])('refuses what is not as it is described: %o', async (received, detail) => {
    const problem = { status: 422, detail };
    expect(await answerTo(received)).toMatchObject({ type: 'error', requestId: 'mine', problem });
  });
});
