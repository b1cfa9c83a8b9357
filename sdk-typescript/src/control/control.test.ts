import { describe, expect, it } from 'vitest';
import type { CommandOutcomeView } from '../contract/schemas.js';
import { Failed, Refused } from '../command/command-error.js';
import { connected, until } from '../testing/connected.js';
import { ControlLost } from './control.js';

const all = connected();
const KEEP = 'POST /api/v1/drones/d1/control/heartbeat';
const RELEASE = 'DELETE /api/v1/drones/d1/control';

const commanded = (): unknown[] =>
  all.server.asked
    .filter(({ what }) => what.endsWith('/commands'))
    .map(({ body }) => [body['type'], body['epoch']]);

/** Commands end so as soon as they are given. */
const ending = (result: CommandOutcomeView['result']): void => {
  all.server.onGiven = ({ id }) => {
    const outcome = { result, by: null, reason: null, code: null };
    setImmediate(() => all.server.setCommand(id, { phase: 'done', outcome }));
  };
};

describe('control of a drone', () => {
  it('is kept by heartbeats and given back', async () => {
    const control = await all.drone.control();
    expect(all.server.control).toMatchObject({ state: 'held', epoch: 1 });
    await until(() => expect(all.server.countOf(KEEP)).toBeGreaterThan(1));
    expect(all.server.asked.find(({ what }) => what === KEEP)?.body).toEqual({ epoch: 1 });
    await control.end();
    expect(all.server.control.state).toBe('free');
    const heartbeats = all.server.countOf(KEEP);
    await control.end();
    expect(all.server.countOf(RELEASE)).toBe(1);
    expect(all.server.countOf(KEEP)).toBe(heartbeats);
    expect(commanded()).toEqual([]);
  });

  it('is named by commands that are given under it, and by none after it', async () => {
    const control = await all.drone.control();
    await all.drone.command({ type: 'arm' });
    await control.end();
    await all.drone.command({ type: 'arm' });
    expect(commanded()).toEqual([
      ['arm', 1],
      ['arm', undefined],
    ]);
  });

  it.each([
    [undefined, [['returnToLaunch', 1]]],
    ['returnHome', [['returnToLaunch', 1]]],
    ['land', [['land', 1]]],
    ['hold', [['hold', 1]]],
    ['keep', []],
  ] as const)('that ends in the air does what was agreed: %s', async (onExit, commands) => {
    ending('succeeded');
    {
      await using control = await all.drone.control({ onExit });
      expect(control.epoch).toBe(1);
      all.server.setDrone({ armed: true, flight: 'inAir' });
    }
    expect(commanded()).toEqual(commands);
    expect(all.server.control.state).toBe('free');
  });

  it.each([
    [{ armed: true, flight: 'landing' }, false],
    [{ armed: false, flight: null }, false],
    [{ armed: true, flight: null }, true],
    [{ armed: true, flight: 'takingOff' }, true],
  ] as const)('that ends with the drone %o sends it home: %s', async (state, home) => {
    ending('succeeded');
    all.server.setDrone(state);
    await (await all.drone.control()).end();
    expect(commanded()).toHaveLength(home ? 1 : 0);
  });

  it('ends with the work, also with work that fails', async () => {
    ending('succeeded');
    expect(await all.drone.control(async ({ epoch }) => epoch)).toBe(1);
    expect(all.server.control.state).toBe('free');
    all.server.setDrone({ armed: true, flight: 'inAir' });
    const fails = all.drone.control(() => Promise.reject(new Error('no pictures')));
    await expect(fails).rejects.toThrow('no pictures');
    expect(commanded()).toEqual([['returnToLaunch', 2]]);
    expect(all.server.control.state).toBe('free');
  });

  it('is given back also where the drone does not come home, which is told', async () => {
    ending('failed');
    all.server.setDrone({ armed: true, flight: 'inAir' });
    const control = await all.drone.control();
    await expect(control.end()).rejects.toBeInstanceOf(Failed);
    expect(all.server.control.state).toBe('free');
  });

  it('that ends on a line that breaks brings the drone home all the same', async () => {
    ending('succeeded');
    all.server.setDrone({ armed: true, flight: 'inAir' });
    const control = await all.drone.control();
    all.server.faults.set('GET /api/v1/drones/d1', ['request lost', 'answer lost']);
    all.server.faults.set('POST /api/v1/drones/d1/commands', ['answer lost']);
    await control.end();
    expect(new Set(commanded().map(String))).toEqual(new Set(['returnToLaunch,1']));
    expect(all.server.commands.size).toBe(1);
    expect(all.server.control.state).toBe('free');
  });

  it('tells both, why the work failed and why the drone does not come home', async () => {
    ending('failed');
    all.server.setDrone({ armed: true, flight: 'inAir' });
    const fails = all.drone.control(() => {
      throw new Error('No pictures.');
    });
    await expect(fails).rejects.toThrow('No pictures. After that: “returnToLaunch” failed.');
  });

  it('that somebody took over is lost, and nothing is sent to the drone at its end', async () => {
    all.server.setDrone({ armed: true, flight: 'inAir' });
    const control = await all.drone.control();
    all.server.control = { ...all.server.control, holder: 'mia', epoch: 2 };
    await until(() => expect(control.signal.aborted).toBe(true));
    expect(control.signal.reason).toBeInstanceOf(ControlLost);
    expect(String(control.signal.reason)).toContain('Control is lost: Mia has control.');
    await control.end();
    expect(commanded()).toEqual([]);
    expect(all.server.countOf(RELEASE)).toBe(0);
  });

  it('outlives heartbeats that are lost, and takes the epoch of a server that was restarted', async () => {
    const control = await all.drone.control();
    all.server.faults.set(KEEP, ['request lost', { status: 503, problem: { code: 'busy' } }]);
    all.server.control = { ...all.server.control, epoch: 7 };
    await until(() => expect(control.epoch).toBe(7));
    expect(control.signal.aborted).toBe(false);
    await control.end();
  });

  it('is renewed for a command that a restarted server refuses by its old epoch', async () => {
    const control = await all.drone.control();
    all.server.control = { ...all.server.control, epoch: 7 };
    await all.drone.command({ type: 'land' });
    expect(commanded().at(-1)).toEqual(['land', 7]);
    await control.end();
  });

  it('that has ended is not renewed for a command that names it', async () => {
    await all.drone.control();
    all.server.control = { ...all.server.control, holder: 'mia', epoch: 2 };
    await expect(all.drone.command({ type: 'land' })).rejects.toBeInstanceOf(Refused);
    expect(all.server.commands.size).toBe(0);
  });

  it('is refused with the reason while somebody else has it', async () => {
    const problem = { code: 'control-held', detail: 'Mia has control.', holder: 'Mia' };
    all.server.faults.set('POST /api/v1/drones/d1/control/take', [{ status: 409, problem }]);
    await expect(all.drone.control()).rejects.toMatchObject({ status: 409, code: 'control-held' });
  });
});
