import { beforeEach, describe, expect, it } from 'vitest';
import {
  CONNECTS_ANEW,
  DEAD_MILLISECONDS,
  QUIET_MILLISECONDS,
  StreamClient,
  type Socket,
  type Timers,
} from './stream-client.js';
import type { StreamMessage } from '../contract/schemas.js';

class FakeTimers implements Timers {
  time = 0;
  #due: { at: number; action: () => void }[] = [];

  now(): number {
    return this.time;
  }

  after(milliseconds: number, action: () => void): () => void {
    const entry = { at: this.time + milliseconds, action };
    this.#due.push(entry);
    return () => (this.#due = this.#due.filter((one) => one !== entry));
  }

  async advance(milliseconds: number): Promise<void> {
    const end = this.time + milliseconds;
    for (;;) {
      const next = this.#due.filter((one) => one.at <= end).sort((a, b) => a.at - b.at)[0];
      if (next === undefined) {
        break;
      }
      this.time = Math.max(this.time, next.at);
      this.#due = this.#due.filter((one) => one !== next);
      next.action();
      await settle();
    }
    this.time = Math.max(this.time, end);
  }
}

class FakeSocket implements Socket {
  onopen: Socket['onopen'] = null;
  onmessage: Socket['onmessage'] = null;
  onclose: Socket['onclose'] = null;
  onerror: Socket['onerror'] = null;
  closed = false;
  code: number | undefined;

  readonly sent: string[] = [];

  send(text: string): void {
    this.sent.push(text);
  }

  close(code?: number): void {
    this.closed = true;
    this.code = code;
  }

  push(message: StreamMessage | string): void {
    const data = typeof message === 'string' ? message : JSON.stringify(message);
    this.onmessage?.(new MessageEvent('message', { data }));
  }

  drop(): void {
    this.onclose?.();
  }
}

async function settle(): Promise<void> {
  for (let i = 0; i < 5; i++) {
    await Promise.resolve();
  }
}

const PING: StreamMessage = { type: 'ping', at: '2026-01-01T12:00:00Z' };

describe('stream client', () => {
  let timers: FakeTimers;
  let sockets: FakeSocket[];
  let events: string[];
  let retryAt: number;
  let address: () => Promise<string | null>;
  let client: StreamClient;

  beforeEach(async () => {
    timers = new FakeTimers();
    sockets = [];
    events = [];
    address = async () => 'ws://cloud/stream?ticket=1';
    client = new StreamClient(
      {
        address: () => address(),
        open: () => {
          const socket = new FakeSocket();
          sockets.push(socket);
          return socket;
        },
        timers,
      },
      {
        onMessage: (message) => events.push(message.type),
        onUp: () => events.push('UP'),
        onDown: () => events.push('DOWN'),
        onRetryAt: (at) => (retryAt = at),
        onUnauthorized: () => events.push('UNAUTHORIZED'),
      },
    );
    client.start();
    await settle();
  });

  const last = (): FakeSocket => sockets.at(-1) as FakeSocket;

  it('is up with the first message, not with the open socket', () => {
    expect(events).toEqual([]);
    last().push(PING);
    expect(events).toEqual(['UP', 'ping']);
  });

  it('says once that it went down and tries again with growing pauses', async () => {
    last().push(PING);
    last().drop();
    expect(events.slice(2)).toEqual(['DOWN']);
    const pauses = [];
    for (let i = 0; i < 6; i++) {
      pauses.push(retryAt - timers.time);
      await timers.advance(retryAt - timers.time);
      last().drop();
    }
    expect(pauses).toEqual([500, 1000, 2000, 3000, 3000, 3000]);
    expect(events.slice(2)).toEqual(['DOWN']);
  });

  it('comes back by itself and starts with short pauses again', async () => {
    last().push(PING);
    last().drop();
    await timers.advance(500);
    last().push(PING);
    expect(events.slice(2)).toEqual(['DOWN', 'UP', 'ping']);
    last().drop();
    expect(retryAt - timers.time).toBe(500);
  });

  it('reports within three seconds that the connection fell silent, and keeps it', async () => {
    last().push(PING);
    await timers.advance(QUIET_MILLISECONDS - 1);
    expect(events).not.toContain('DOWN');
    await timers.advance(1);
    expect(QUIET_MILLISECONDS).toBeLessThan(3_000);
    expect(events.slice(2)).toEqual(['DOWN']);
    expect(last().closed).toBe(false);
    expect(client.send({ type: 'letGo', requestId: 'r', drone: 'd1' })).toBe(false);
  });

  it('is back at once when a silent line speaks again', async () => {
    last().push(PING);
    await timers.advance(DEAD_MILLISECONDS - 1);
    last().push(PING);
    expect(events.slice(2)).toEqual(['DOWN', 'UP', 'ping']);
    expect(sockets).toHaveLength(1);
  });

  it('gives up a connection that stays silent', async () => {
    last().push(PING);
    const silent = last();
    await timers.advance(DEAD_MILLISECONDS - 1);
    expect(silent.closed).toBe(false);
    await timers.advance(1);
    expect(silent.closed).toBe(true);
    // The cloud takes a page for closed that ends its connection without saying so.
    expect(silent.code).toBe(CONNECTS_ANEW);
    expect(events.filter((what) => what === 'DOWN')).toHaveLength(1);
  });

  it('waits longer each time for a connection that never gets to the end of the list', async () => {
    for (const patience of [1, 2, 4, 4].map((times) => times * DEAD_MILLISECONDS)) {
      const slow = last();
      slow.push({ type: 'hello', user: 'olga', role: 'operator', version: '1.0.0' });
      await timers.advance(patience - 1);
      expect(slow.closed).toBe(false);
      await timers.advance(1);
      expect(slow.closed).toBe(true);
      await timers.advance(retryAt - timers.time);
    }
    last().push(PING);
    const quick = last();
    await timers.advance(DEAD_MILLISECONDS);
    expect(quick.closed).toBe(true);
  });

  it('reads first what came while the page itself stood still', async () => {
    last().push(PING);
    const slept = last();
    timers.time += DEAD_MILLISECONDS + 5_000;
    await timers.advance(0);
    expect(events).not.toContain('DOWN');
    slept.push(PING);
    await timers.advance(QUIET_MILLISECONDS - 1);
    expect(events).not.toContain('DOWN');
    timers.time += 5_000;
    await timers.advance(500);
    expect(events).toContain('DOWN');
    await timers.advance(DEAD_MILLISECONDS - QUIET_MILLISECONDS);
    expect(slept.closed).toBe(true);
  });

  it('goes down when no ticket can be had', async () => {
    last().push(PING);
    address = () => Promise.reject(new Error('unreachable'));
    last().drop();
    await timers.advance(500);
    expect(sockets).toHaveLength(1);
    expect(retryAt - timers.time).toBe(1000);
  });

  it('stops and says so when nobody is signed in any more', async () => {
    last().push(PING);
    address = async () => null;
    last().drop();
    await timers.advance(60_000);
    expect(events.at(-1)).toBe('UNAUTHORIZED');
    expect(sockets).toHaveLength(1);
  });

  it('can be asked to try now', async () => {
    last().push(PING);
    last().drop();
    client.retryNow();
    await settle();
    expect(sockets).toHaveLength(2);
  });

  it('ignores what an old socket says after a reconnect', async () => {
    const old = last();
    old.push(PING);
    const { onmessage } = old;
    old.drop();
    await timers.advance(500);
    const before = events.length;
    onmessage?.(new MessageEvent('message', { data: JSON.stringify(PING) }));
    expect(events).toHaveLength(before);
  });

  it('skips a message that is no JSON', () => {
    last().push('garbage');
    last().push(PING);
    expect(events).toEqual(['UP', 'ping']);
  });

  it('is quiet after it was stopped', async () => {
    last().push(PING);
    client.stop();
    await timers.advance(60_000);
    expect(sockets).toHaveLength(1);
    expect(events).toEqual(['UP', 'ping']);
  });
});
