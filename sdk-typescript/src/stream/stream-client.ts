import type { StreamMessage, StreamRequest } from '../contract/schemas.js';
import type { ProblemBody } from '../rest/problem.js';

/** The part of a WebSocket that is told; that of a browser and that of the package ws are such. */
export interface SocketHandle {
  send(text: string): void;
  close(code?: number): void;
}

export type SocketClass = new (address: string) => SocketHandle;

/** The part of a WebSocket that the stream uses, so that tests can play the server. */
export interface Socket extends SocketHandle {
  onopen: (() => void) | null;
  onmessage: ((event: { readonly data: unknown }) => void) | null;
  onclose: (() => void) | null;
  onerror: (() => void) | null;
}

/** Opens one of that class; without one, of the class that browsers and Node from version 22 on have. */
export function openSocket(address: string, given?: SocketClass): Socket {
  const known = given ?? (globalThis as { WebSocket?: SocketClass }).WebSocket;
  if (known === undefined) {
    throw new Error(
      'This version of Node has no WebSocket: give one to connect, such as that of the package ws.',
    );
  }
  return new known(address) as Socket;
}

export interface StreamListener {
  onMessage(message: StreamMessage): void;
  /** The first message after (re)connecting has arrived: what is shown is true again. */
  onUp(): void;
  /** Called once when nothing comes any more, not for every failed try; the connection may be there still. */
  onDown(): void;
  /** The time of the next try, by the clock of `Timers.now`. */
  onRetryAt(at: number): void;
  /** The server no longer knows who we are: sign in again. With its problem, where it said one on the stream. */
  onUnauthorized(problem?: ProblemBody): void;
}

export interface Timers {
  now(): number;
  after(milliseconds: number, action: () => void): () => void;
}

export const systemTimers: Timers = {
  now: () => performance.now(),
  after: (milliseconds, action) => {
    const handle = setTimeout(action, milliseconds);
    return () => clearTimeout(handle);
  },
};

/** The address of the stream: at the host of REST. */
export function streamAddress(
  { protocol, hostname }: { readonly protocol: string; readonly hostname: string },
  port: number,
  { ticket, rate }: { readonly ticket: string | null; readonly rate: number },
): string {
  const scheme = protocol === 'https:' ? 'wss' : 'ws';
  const proof = ticket === null ? '' : `ticket=${encodeURIComponent(ticket)}&`;
  return `${scheme}://${hostname}:${port}/stream?${proof}rate=${rate}`;
}

export interface StreamOptions {
  /** Fetches a one-use ticket and answers the address to open; null when nobody is signed in. */
  address(): Promise<string | null>;
  open(address: string): Socket;
  /** Said first on each connection, by who has no ticket; an error of status 401 is its answer then. */
  greeting?: StreamRequest;
  timers: Timers;
}

/** The server sends a message at least once a second: after so long without one, what is shown is old. */
export const QUIET_MILLISECONDS = 2_500;
/** After so long without a message another connection is made; longer each time, for links on which the first list takes long. */
export const DEAD_MILLISECONDS = 5_000;
const LONGEST_DEAD_MILLISECONDS = 20_000;
/** A timer that is so much late was held up by the page. */
const LATE_MILLISECONDS = 1_000;
/** The time in which a resumed page reads what waits. */
const READS_MILLISECONDS = 500;
/** The close code of a page that reconnects: it only gives up a connection that seems dead. */
export const CONNECTS_ANEW = 4000;
const FIRST_RETRY_MILLISECONDS = 500;
const LONGEST_RETRY_MILLISECONDS = 3_000;

/**
 * Keeps one stream to the cloud open: reports soon that it fell silent, and reconnects with growing pauses
 * when no message comes.
 */
export class StreamClient {
  readonly #options: StreamOptions;
  readonly #listener: StreamListener;
  #socket: Socket | null = null;
  #attempt = 0;
  #generation = 0;
  #up = false;
  #down = false;
  #deadAfter = DEAD_MILLISECONDS;
  #cancelTimer: () => void = () => undefined;

  constructor(options: StreamOptions, listener: StreamListener) {
    this.#options = options;
    this.#listener = listener;
  }

  start(): void {
    this.#attempt = 0;
    void this.#connect();
  }

  stop(): void {
    this.#drop();
    this.#up = false;
    this.#down = false;
  }

  /** False without a connection: what is sent many times a second is not kept for later. */
  send(request: StreamRequest): boolean {
    if (!this.#up || this.#socket === null) {
      return false;
    }
    this.#socket.send(JSON.stringify(request));
    return true;
  }

  /** Tries now instead of waiting for the next planned try. */
  retryNow(): void {
    if (!this.#up) {
      this.#drop(CONNECTS_ANEW);
      void this.#connect();
    }
  }

  async #connect(): Promise<void> {
    const generation = ++this.#generation;
    let address: string | null;
    try {
      address = await this.#options.address();
    } catch {
      if (generation === this.#generation) {
        this.#fail();
      }
      return;
    }
    if (generation !== this.#generation) {
      return;
    }
    if (address === null) {
      this.stop();
      this.#listener.onUnauthorized();
      return;
    }
    this.#listen(this.#options.open(address), generation);
  }

  #listen(socket: Socket, generation: number): void {
    this.#socket = socket;
    this.#watchSilence();
    // It is closed after that, which is heard; in Node an error that nobody listens to would end the program.
    socket.onerror = () => undefined;
    const { greeting } = this.#options;
    if (greeting !== undefined) {
      socket.onopen = () => socket.send(JSON.stringify(greeting));
    }
    socket.onmessage = (event) => {
      if (generation === this.#generation) {
        this.#receive(String(event.data));
      }
    };
    socket.onclose = () => {
      if (generation === this.#generation) {
        this.#fail();
      }
    };
  }

  #receive(text: string): void {
    this.#watchSilence();
    let message: StreamMessage;
    try {
      message = JSON.parse(text) as StreamMessage;
    } catch {
      // Not ours; the next whole message mends what this one would have said.
      console.warn('The stream sent a message that is no JSON.');
      return;
    }
    if (!this.#up && this.#options.greeting !== undefined && message.type === 'error') {
      this.#refused(message.problem);
      return;
    }
    if (!this.#up) {
      this.#up = true;
      this.#down = false;
      this.#attempt = 0;
      this.#listener.onUp();
    }
    if (message.type === 'ping') {
      // All that was to be said before it has come.
      this.#deadAfter = DEAD_MILLISECONDS;
    }
    this.#listener.onMessage(message);
  }

  /** Any other problem than that of the proof is over some time. */
  #refused(problem: ProblemBody): void {
    if (problem.status === 401) {
      this.stop();
      this.#listener.onUnauthorized(problem);
    } else {
      this.#fail();
    }
  }

  #watchSilence(): void {
    this.#after(QUIET_MILLISECONDS, () => {
      this.#goDown();
      this.#after(this.#deadAfter - QUIET_MILLISECONDS, () => {
        this.#deadAfter = Math.min(LONGEST_DEAD_MILLISECONDS, this.#deadAfter * 2);
        this.#fail();
      });
    });
  }

  #after(milliseconds: number, action: () => void): void {
    this.#cancelTimer();
    const { timers } = this.#options;
    const due = timers.now() + milliseconds;
    this.#cancelTimer = timers.after(milliseconds, () => {
      if (timers.now() - due > LATE_MILLISECONDS) {
        // This page itself stood still: what came meanwhile waits to be read.
        this.#cancelTimer = timers.after(READS_MILLISECONDS, action);
      } else {
        action();
      }
    });
  }

  #goDown(): void {
    this.#up = false;
    if (!this.#down) {
      this.#down = true;
      this.#listener.onDown();
    }
  }

  #fail(): void {
    this.#drop(CONNECTS_ANEW);
    this.#goDown();
    const pause = Math.min(LONGEST_RETRY_MILLISECONDS, FIRST_RETRY_MILLISECONDS * 2 ** this.#attempt);
    this.#attempt += 1;
    this.#listener.onRetryAt(this.#options.timers.now() + pause);
    this.#cancelTimer = this.#options.timers.after(pause, () => void this.#connect());
  }

  #drop(code?: number): void {
    this.#generation += 1;
    this.#cancelTimer();
    const socket = this.#socket;
    this.#socket = null;
    if (socket !== null) {
      socket.onopen = null;
      socket.onclose = null;
      socket.onmessage = null;
      socket.close(code);
    }
  }
}
