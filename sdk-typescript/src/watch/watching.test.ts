import { describe, expect, it } from 'vitest';
import { WebSocket } from 'ws';
import { Dronemap } from '../dronemap.js';
import { Problem } from '../rest/problem.js';
import { connected, take, until } from '../testing/connected.js';
import { aDrone } from '../testing/fake-server.js';
import { quickTimers } from '../testing/quick-timers.js';
import type { Change } from './watching.js';

const all = connected();
const upAndRunning = (): Promise<void> => until(() => expect(all.server.listeners).toBe(1));

describe('states of a drone', () => {
  it('begin with what it is now, and go on with what it becomes', async () => {
    const states = all.drone.states({ rate: 50 })[Symbol.asyncIterator]();
    expect((await states.next()).value).toMatchObject({ flight: 'onGround' });
    await upAndRunning();
    all.server.setDrone({ flight: 'takingOff' });
    let now = await states.next();
    while (now.value?.flight === 'onGround') {
      now = await states.next();
    }
    expect(now.value).toMatchObject({ flight: 'takingOff' });
    await states.return?.();
  });

  it('are read by several at once over one connection, by each to its end', async () => {
    const states = all.drone.states({ rate: 50 });
    const readers = [states, states, all.drone.states({ rate: 10 })].map(async (source) => {
      for await (const { mode } of source) {
        if (mode === 'RTL') {
          return mode;
        }
      }
      return null;
    });
    await upAndRunning();
    all.server.setDrone({ mode: 'RTL' });
    expect(await Promise.all(readers)).toEqual(['RTL', 'RTL', 'RTL']);
    expect(all.server.connections).toBe(1);
    expect(all.server.heard.find(({ type }) => type === 'subscribe')).toMatchObject({
      drones: ['d1'],
      rate: 50,
    });
  });

  it('that came while nobody read are told by the newest', async () => {
    const states = all.drone.states({ rate: 1 })[Symbol.asyncIterator]();
    await states.next();
    await upAndRunning();
    for (let version = 2; version <= 40; version++) {
      all.server.setDrone({ version });
    }
    let versions = 0;
    for (let now = await states.next(); ; now = await states.next()) {
      versions += 1;
      if (now.value?.version === 40) {
        break;
      }
    }
    expect(versions).toBeLessThan(10);
    await states.return?.();
  });

  it('go on over a line that breaks', async () => {
    const landed = all.drone.waitFor(({ flight }) => flight === 'landing');
    const subscriptions = (): number => all.server.heard.filter(({ type }) => type === 'subscribe').length;
    await until(() => expect(subscriptions()).toBe(1));
    all.server.breakLines();
    await until(() => expect(all.server.listeners).toBe(0));
    all.server.drones.set('d1', aDrone({ flight: 'landing', version: 2 }));
    expect((await landed).flight).toBe('landing');
    expect(all.server.connections).toBeGreaterThan(1);
    // A new connection knows nothing of what was subscribed to on the one before.
    await until(() => expect(subscriptions()).toBeGreaterThan(1));
  });

  it('end with the drone, with the signal, and with the connection', async () => {
    const gone = take(all.drone.states(), 99);
    const waiting = all.drone.waitFor(() => false);
    await upAndRunning();
    all.server.say({ type: 'droneRemoved', id: 'd1' });
    await expect(gone).resolves.toHaveLength(1);
    await expect(waiting).rejects.toThrow('did not come true for Copter 1 before the drone was removed');

    const stop = new AbortController();
    const stopped = take(all.drone.states({ signal: stop.signal }), 99);
    stop.abort(new Error('seen enough'));
    await expect(stopped).rejects.toThrow('seen enough');
    await expect(take(all.drone.states({ signal: stop.signal }), 1)).rejects.toThrow('seen enough');

    const closed = take(all.drone.states(), 99);
    await upAndRunning();
    all.dronemap.close();
    await expect(closed).rejects.toThrow('The connection to the cloud was closed.');
  });

  it('are waited for no longer than is asked', async () => {
    await expect(all.drone.waitFor(({ armed }) => armed === true, { timeout: 500 })).rejects.toThrow(
      'What was waited for did not come true for Copter 1 within 0.5 s.',
    );
  });

  it('of a drone that is none are a problem', async () => {
    all.server.drones.clear();
    await expect(all.drone.waitFor(() => true)).rejects.toMatchObject({ status: 404, code: 'drone-unknown' });
  });

  it('leave the connection when nobody reads them', async () => {
    const states = all.drone.states()[Symbol.asyncIterator]();
    await states.next();
    await upAndRunning();
    await states.return?.();
    await until(() => expect(all.server.listeners).toBe(0));
    const again = all.drone.states()[Symbol.asyncIterator]();
    await again.next();
    await upAndRunning();
    expect(all.server.connections).toBe(2);
    await again.return?.();
  });
});

/** In a word each. */
async function readToEnd(changes: AsyncIterator<Change>): Promise<string[]> {
  const told: string[] = [];
  while (told.at(-1) !== 'end') {
    const { value: change } = (await changes.next()) as { value: Change };
    const { type } = change;
    told.push(
      type === 'command' ? change.command.phase : type === 'drone' ? String(change.drone.mode) : type,
    );
  }
  await changes.return?.();
  return told;
}

describe('changes', () => {
  it('are all that the stream tells, but for answers and signs of life', async () => {
    const changes = all.dronemap.changes()[Symbol.asyncIterator]();
    const first = changes.next();
    expect((await first).value).toMatchObject({ type: 'drones' });
    all.server.say({ type: 'weather' });
    all.server.setDrone({ mode: 'RTL' });
    expect((await changes.next()).value).toMatchObject({ type: 'weather' });
    expect((await changes.next()).value).toMatchObject({ type: 'drone', drone: { mode: 'RTL' } });
    await until(() => expect(all.server.heard.at(-1)).toMatchObject({ type: 'subscribe', drones: null }));
    await changes.return?.();
  });

  it('begin with all drones, also for who comes later', async () => {
    const first = all.dronemap.changes()[Symbol.asyncIterator]();
    await first.next();
    all.server.setDrone({ mode: 'RTL' });
    await first.next();
    const second = all.dronemap.changes({ drones: ['d1'] })[Symbol.asyncIterator]();
    expect((await second.next()).value).toMatchObject({
      type: 'drones',
      drones: [{ id: 'd1', mode: 'RTL' }],
    });
    const none = all.dronemap.changes({ drones: ['d9'] })[Symbol.asyncIterator]();
    expect((await none.next()).value).toEqual({ type: 'drones', drones: [] });
    await Promise.all([first.return?.(), second.return?.(), none.return?.()]);
  });

  it('tell each phase of a command, and to who reads slowly of a drone the newest', async () => {
    const [slow, quick] = [all.dronemap.changes(), all.dronemap.changes()].map((one) =>
      one[Symbol.asyncIterator](),
    ) as [AsyncIterator<Change>, AsyncIterator<Change>];
    await Promise.all([slow.next(), quick.next()]);
    all.server.setCommand('c-12345678', { id: 'c-12345678', phase: 'sent' });
    all.server.setDrone({ mode: 'RTL' });
    all.server.setCommand('c-12345678', { phase: 'accepted' });
    all.server.setDrone({ mode: 'LAND' });
    all.server.say({ type: 'end' });
    // What the quick one has read has come to the slow one as well.
    await readToEnd(quick);
    expect(await readToEnd(slow)).toEqual(['sent', 'LAND', 'accepted', 'end']);
  });

  it('say that some were missed while the line was broken', async () => {
    const changes = all.dronemap.changes()[Symbol.asyncIterator]();
    await changes.next();
    all.server.breakLines();
    expect((await changes.next()).value).toEqual({ type: 'gap', lost: null });
    expect((await changes.next()).value).toMatchObject({ type: 'drones' });
    await changes.return?.();
  });
});

describe('a connection', () => {
  it('names who it is for, the drones in sight, and the version of the server', async () => {
    all.server.drones.set('d2', aDrone({ id: 'd2', name: 'Copter 1' }));
    all.server.drones.set('d3', aDrone({ id: 'd3', name: 'Rover' }));
    expect(all.dronemap.user).toMatchObject({ name: 'olga', role: 'operator' });
    expect(all.dronemap.serverVersion).toBe('0.1.0');
    expect((await all.dronemap.drones()).map(({ name }) => name)).toEqual(['Copter 1', 'Copter 1', 'Rover']);
    expect(await all.dronemap.drone('Rover')).toMatchObject({ id: 'd3' });
    await expect(all.dronemap.drone('Copter 1')).rejects.toThrow('ask for one by its id: d1, d2.');
    await expect(all.dronemap.drone('Plane')).rejects.toThrow(
      'There is no drone “Plane”; there are: Copter 1',
    );
  });

  it('is refused with the reason where the key is none, at once and later', async () => {
    const options = { url: all.server.url, key: 'none', WebSocket, timers: quickTimers };
    await expect(Dronemap.connect(options)).rejects.toMatchObject({ status: 401, code: 'key-unknown' });
  });

  it('says where the server is, unless it is that of the page', async () => {
    await expect(Dronemap.connect({ key: 'k' })).rejects.toThrow('say where the server is');
  });

  it('of a page shows its session, and the stream a ticket', async () => {
    const { url } = all.server;
    await using page = await Dronemap.connect({ url, session: true, WebSocket, timers: quickTimers });
    expect(await take(page.changes(), 1)).toMatchObject([{ type: 'drones' }]);
    expect(all.server.heard.some(({ type }) => type === 'authenticate')).toBe(false);
  });

  it('ends for all who read when its key is taken away', async () => {
    const states = take(all.drone.states(), 99).catch((thrown: unknown) => thrown);
    await upAndRunning();
    all.server.key = 'another key';
    all.server.breakLines();
    const thrown = await states;
    expect(thrown).toBeInstanceOf(Problem);
    expect(thrown).toMatchObject({ status: 401, message: 'This access key is none.' });
  });
});
