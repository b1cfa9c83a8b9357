import type { DroneView, StreamMessage } from '../contract/schemas.js';
import type { RestOperations } from '../contract/operations.js';
import { Problem } from '../rest/problem.js';
import type { Timers } from '../stream/stream-client.js';
import { pause } from '../timing.js';
import { NewestQueue } from './newest-queue.js';
import type { SharedStream, Watcher } from './shared-stream.js';

export interface StatesOptions {
  /** At most so many states a second, up to 50. */
  readonly rate?: number | undefined;
  readonly signal?: AbortSignal | undefined;
}

export interface ChangesOptions extends StatesOptions {
  /** Ids of the drones of which changes are told; without: of all. */
  readonly drones?: readonly string[] | undefined;
}

/** What a reader has missed: so many changes, or null: the connection was lost, nobody knows how many. */
export interface Gap {
  readonly type: 'gap';
  readonly lost: number | null;
}

type Answer = 'hello' | 'ping' | 'pong' | 'error' | 'commandAccepted' | 'controlAnswer' | 'positionsHeard';

/** What has changed. A newer server may tell of types that are not named here. */
export type Change = Exclude<StreamMessage, { type: Answer }> | Gap;

export const DEFAULT_RATE = 5;
/** A reader who is so far behind loses the oldest of it. */
const MOST_CHANGES = 10_000;
const NO_CHANGES: ReadonlySet<string> = new Set<Answer>([
  'hello',
  'ping',
  'pong',
  'error',
  'commandAccepted',
  'controlAnswer',
  'positionsHeard',
]);

/** Several may read it, each for itself and from its own beginning. */
export function readable<T>(read: () => AsyncGenerator<T, void, undefined>): AsyncIterable<T> {
  return { [Symbol.asyncIterator]: read };
}

/** The state of a drone as it is, then each newer one; who reads slowly gets the newest. Ends when the drone is gone. */
export async function* statesOf(
  drone: string,
  ports: { readonly stream: SharedStream; readonly rest: RestOperations; readonly timers: Timers },
  { rate = DEFAULT_RATE, signal }: StatesOptions,
): AsyncGenerator<DroneView, void, undefined> {
  signal?.throwIfAborted();
  const queue = new NewestQueue<DroneView>(1);
  let told: number | null = null;
  const push = (state: DroneView): void => {
    if (state.version !== told) {
      told = state.version;
      queue.push('state', state);
    }
  };
  const remove = ports.stream.add({
    drones: [drone],
    rate,
    onMessage: (message) => applyTo(drone, message, push, () => queue.end()),
    onEnd: (reason) => queue.end(reason),
  });
  try {
    // The stream says a drone's state when it connects, or when that changes: neither need be soon.
    const state = await orLater(ports.rest.getDrone({ id: drone }, { signal }));
    if (told === null && state !== undefined) {
      push(state);
    }
    for (let next = await queue.next(signal); next !== undefined; next = await queue.next(signal)) {
      yield next.value;
      await pause(ports.timers, 1000 / rate, signal);
    }
  } finally {
    remove();
  }
}

/** undefined: the server cannot be reached now; the stream goes on when it can. */
async function orLater<T>(answer: Promise<T>): Promise<T | undefined> {
  try {
    return await answer;
  } catch (thrown) {
    if (thrown instanceof Problem && thrown.mayPass) {
      return undefined;
    }
    throw thrown;
  }
}

function applyTo(
  drone: string,
  message: StreamMessage,
  push: (state: DroneView) => void,
  gone: () => void,
): void {
  if (message.type === 'drone' && message.drone.id === drone) {
    push(message.drone);
  } else if (message.type === 'drones') {
    const state = message.drones.find(({ id }) => id === drone);
    if (state === undefined) {
      gone();
    } else {
      push(state);
    }
  } else if (message.type === 'droneRemoved' && message.id === drone) {
    gone();
  }
}

/** All drones, then whatever changes; of what has a state the newest, of commands and control each change. */
export async function* changesOf(
  { stream, rest }: { readonly stream: SharedStream; readonly rest: RestOperations },
  { rate = DEFAULT_RATE, drones, signal }: ChangesOptions,
): AsyncGenerator<Change, void, undefined> {
  signal?.throwIfAborted();
  const queue = new NewestQueue<Change>(MOST_CHANGES);
  const wasUp = stream.isUp;
  const remove = stream.add(changesWatcher(queue, drones ?? null, rate));
  try {
    if (wasUp) {
      // The stream has said them when it connected, for another reader.
      const all = await orLater(rest.listDrones({}, { signal }));
      if (all !== undefined) {
        yield { type: 'drones', drones: all.drones.filter(({ id }) => drones?.includes(id) ?? true) };
      }
    }
    for (let next = await queue.next(signal); next !== undefined; next = await queue.next(signal)) {
      const lost = queue.takeLost();
      if (lost > 0) {
        yield { type: 'gap', lost };
      }
      yield next.value;
    }
  } finally {
    remove();
  }
}

function changesWatcher(queue: NewestQueue<Change>, drones: readonly string[] | null, rate: number): Watcher {
  let wasDown = false;
  return {
    drones,
    rate,
    onMessage: (message) => {
      if (!NO_CHANGES.has(message.type)) {
        queue.push(keyOf(message), message as Change);
      }
    },
    onDown: () => (wasDown = true),
    onUp: () => {
      if (wasDown) {
        wasDown = false;
        queue.push('gap', { type: 'gap', lost: null });
      }
    },
    onEnd: (reason) => queue.end(reason),
  };
}

/** Of what has the same key only the newest is worth reading. */
function keyOf(message: StreamMessage): unknown {
  switch (message.type) {
    case 'drone':
      return `drone ${message.drone.id}`;
    case 'droneRemoved':
      return `drone ${message.id}`;
    case 'followNow':
      return `followNow ${message.id}`;
    case 'dispatchNow':
      return `dispatchNow ${message.id}`;
    case 'run':
      return `run ${message.run.id}`;
    case 'recovery':
      return `recovery ${message.recovery.id}`;
    case 'plan':
      return `plan ${message.plan.id}`;
    case 'virtualDrone':
      return `virtualDrone ${message.virtualDrone.id}`;
    default:
      return {};
  }
}
