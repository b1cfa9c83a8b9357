import { afterEach, beforeEach, vi } from 'vitest';
import { WebSocket } from 'ws';
import type { Drone } from '../drone.js';
import { Dronemap } from '../dronemap.js';
import { FakeServer, KEY } from './fake-server.js';
import { quickTimers } from './quick-timers.js';

export interface Connected {
  server: FakeServer;
  dronemap: Dronemap;
  drone: Drone;
}

/** A server for each test, a connection to it, and its one drone. */
export function connected(): Connected {
  const all = {} as Connected;
  beforeEach(async () => {
    all.server = await FakeServer.start();
    all.dronemap = await Dronemap.connect({
      url: all.server.url,
      key: KEY,
      WebSocket,
      timers: quickTimers,
    });
    all.drone = await all.dronemap.drone('Copter 1');
  });
  afterEach(async () => {
    all.dronemap.close();
    await all.server.close();
  });
  return all;
}

/** Reads until so many have come. */
export async function take<T>(source: AsyncIterable<T>, count: number): Promise<T[]> {
  const taken: T[] = [];
  for await (const one of source) {
    taken.push(one);
    if (taken.length === count) {
      break;
    }
  }
  return taken;
}

/** Waits until that holds. */
export function until(check: () => void): Promise<void> {
  return vi.waitFor(check, { timeout: 20_000, interval: 10 });
}
