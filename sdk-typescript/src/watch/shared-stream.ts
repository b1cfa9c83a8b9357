import type { RestOperations } from '../contract/operations.js';
import type { StreamMessage } from '../contract/schemas.js';
import { Problem } from '../rest/problem.js';
import {
  openSocket,
  StreamClient,
  streamAddress,
  type SocketClass,
  type StreamListener,
  type Timers,
} from '../stream/stream-client.js';

/** Who reads the stream, for as long as it is added. */
export interface Watcher {
  /** Ids of the drones that it is about; null: all. */
  readonly drones: readonly string[] | null;
  /** States of each drone a second. */
  readonly rate: number;
  onMessage?(message: StreamMessage): void;
  /** What comes from now on is true again; what was said before the connection was lost may be old. */
  onUp?(): void;
  onDown?(): void;
  /** Nothing comes any more. */
  onEnd(reason: Error): void;
}

export interface SharedStreamOptions {
  /** Where REST is. */
  readonly url: string;
  readonly key: string | undefined;
  readonly rest: RestOperations;
  readonly socketClass: SocketClass | undefined;
  readonly timers: Timers;
}

/** So that who waits for one thing after another does not connect for each. */
const LINGER_MILLISECONDS = 1_000;
const ASK_MILLISECONDS = 4_000;

/** One connection to the stream for all who read it: opened for the first, closed after the last. */
export class SharedStream {
  readonly #options: SharedStreamOptions;
  readonly #watchers = new Set<Watcher>();
  readonly #client: StreamClient;
  #running = false;
  #up = false;
  #port: number | null = null;
  #wanted = '';
  #cancelStop: () => void = () => undefined;

  constructor(options: SharedStreamOptions) {
    this.#options = options;
    const { key, socketClass, timers } = options;
    const listener: StreamListener = {
      onMessage: (message) => this.#watchers.forEach((one) => one.onMessage?.(message)),
      onUp: () => this.#setUp(true),
      onDown: () => this.#setUp(false),
      onRetryAt: () => undefined,
      onUnauthorized: (problem) => this.end(new Problem(problem ?? NOT_KNOWN)),
    };
    const greeting = key === undefined ? {} : { greeting: { type: 'authenticate', key } as const };
    const open = (address: string): ReturnType<typeof openSocket> => openSocket(address, socketClass);
    this.#client = new StreamClient({ address: () => this.#address(), open, timers, ...greeting }, listener);
  }

  /** What is told is heard at once. */
  get isUp(): boolean {
    return this.#up;
  }

  /** False where nothing can open it. */
  get isThere(): boolean {
    return this.#options.socketClass !== undefined || 'WebSocket' in globalThis;
  }

  /**
   * Answers how to take it out again.
   *
   * @throws Error where there is no WebSocket
   */
  add(watcher: Watcher): () => void {
    if (!this.isThere) {
      throw new Error(
        'This version of Node has no WebSocket: give connect one, such as that of the package ws.',
      );
    }
    this.#watchers.add(watcher);
    this.#cancelStop();
    if (this.#running) {
      this.#subscribe();
    } else {
      this.#running = true;
      this.#client.start();
    }
    return () => this.#remove(watcher);
  }

  /** Ends it for all who read; who is added later opens it again. */
  end(reason: Error): void {
    this.#stop();
    const watchers = [...this.#watchers];
    this.#watchers.clear();
    watchers.forEach((one) => one.onEnd(reason));
  }

  #remove(watcher: Watcher): void {
    if (this.#watchers.delete(watcher) && this.#watchers.size === 0 && this.#running) {
      this.#cancelStop();
      this.#cancelStop = this.#options.timers.after(LINGER_MILLISECONDS, () => this.#stop());
    } else if (this.#watchers.size > 0) {
      this.#subscribe();
    }
  }

  #stop(): void {
    this.#cancelStop();
    this.#client.stop();
    this.#running = false;
    this.#up = false;
  }

  #setUp(up: boolean): void {
    this.#up = up;
    if (up) {
      this.#wanted = '';
      this.#subscribe();
    }
    this.#watchers.forEach((one) => (up ? one.onUp?.() : one.onDown?.()));
  }

  /** To what all who read need together. */
  #subscribe(): void {
    const all = [...this.#watchers];
    const isOfAll = all.some(({ drones }) => drones === null);
    const drones = isOfAll ? null : [...new Set(all.flatMap((one) => one.drones ?? []))].sort();
    const rate = Math.min(50, Math.max(1, Math.ceil(Math.max(...all.map((one) => one.rate)))));
    const wanted = JSON.stringify({ drones, rate });
    if (this.#up && wanted !== this.#wanted) {
      this.#wanted = wanted;
      this.#client.send({ type: 'subscribe', requestId: 'subscribe', drones, rate });
    }
  }

  /** null: nobody is signed in any more. */
  async #address(): Promise<string | null> {
    const { url, key, rest } = this.#options;
    const options = { timeout: ASK_MILLISECONDS };
    try {
      this.#port ??= (await rest.getSettings(options)).streamPort;
      const ticket = key === undefined ? (await rest.makeStreamTicket(options)).ticket : null;
      return streamAddress(new URL(url), this.#port, { ticket, rate: 5 });
    } catch (thrown) {
      if (thrown instanceof Problem && thrown.status === 401) {
        return null;
      }
      throw thrown;
    }
  }
}

const NOT_KNOWN = {
  status: 401,
  code: 'sign-in-needed',
  detail: 'The cloud does not know this session or access key any more.',
};
