import { describe, expect, it, vi } from 'vitest';
import type { CommandOutcomeView } from '../contract/schemas.js';
import { Dronemap } from '../dronemap.js';
import { Problem } from '../rest/problem.js';
import { connected, until } from '../testing/connected.js';
import { KEY } from '../testing/fake-server.js';
import { quickTimers } from '../testing/quick-timers.js';
import { Failed, OutcomeUnknown, Refused, Superseded, TimedOut } from './command-error.js';

const all = connected();
const GIVE = 'POST /api/v1/drones/d1/commands';
const succeeded: CommandOutcomeView = { result: 'succeeded', by: null, reason: null, code: null };

const ending = (outcome: Partial<CommandOutcomeView>): void => {
  all.server.onGiven = ({ id }) => {
    const whole = { ...succeeded, ...outcome } as CommandOutcomeView;
    setImmediate(() => all.server.setCommand(id, { phase: 'done', outcome: whole }));
  };
};

describe('a command', () => {
  it('has an id of its own, and succeeds when the stream says so', async () => {
    const command = await all.drone.command({ type: 'takeOff', altitude: 20 });
    await until(() => expect(all.server.countOf(GIVE)).toBe(1));
    const { body } = all.server.asked.find(({ what }) => what === GIVE) ?? {};
    expect(body).toMatchObject({ type: 'takeOff', altitude: 20, id: command.id });
    expect(command.id).toMatch(/^[A-Za-z0-9_-]{8,64}$/);
    const outcome = command.outcome({ timeout: 60_000 });
    await until(() => expect(all.server.heard.some(({ type }) => type === 'subscribe')).toBe(true));
    all.server.setCommand(command.id, { phase: 'accepted' });
    all.server.setCommand(command.id, { phase: 'done', outcome: succeeded });
    expect((await outcome).outcome?.result).toBe('succeeded');
    expect(command.view.phase).toBe('done');
  });

  it.each([
    [{ result: 'refused', by: 'vehicle', reason: 'PreArm: Bad fix', code: 'vehicle-refused' }, Refused],
    [{ result: 'failed', reason: 'It did not climb.' }, Failed],
    [{ result: 'timedOut', reason: 'No answer within 5 s.' }, TimedOut],
    [{ result: 'superseded', reason: 'Land took its place.' }, Superseded],
    [{ result: 'unknown', reason: 'The link broke.' }, OutcomeUnknown],
    [{ result: 'postponed', reason: 'A newer server says so.' }, OutcomeUnknown],
  ])('that ends as %o is thrown as what it is', async (outcome, kind) => {
    ending(outcome as Partial<CommandOutcomeView>);
    const command = await all.drone.command({ type: 'arm' });
    const thrown = await command.outcome().catch((one: unknown) => one);
    expect(thrown).toBeInstanceOf(kind);
    expect(thrown).toMatchObject({ message: outcome.reason, commandId: command.id, name: kind.name });
    if (thrown instanceof Refused) {
      expect(thrown).toMatchObject({ by: 'vehicle', code: 'vehicle-refused' });
    }
  });

  it('says itself what the server gives no reason for', async () => {
    ending({ result: 'failed' });
    const command = await all.drone.command({ type: 'arm' });
    await expect(command.outcome()).rejects.toThrow('“arm” failed.');
  });

  it('that the gate refuses is thrown at once', async () => {
    const problem = { commandId: 'c-12345678', code: 'not-armed', detail: 'Arm first.' };
    all.server.faults.set(GIVE, [{ status: 409, problem }]);
    const thrown = await all.drone.command({ type: 'takeOff', altitude: 20 }).catch((one: unknown) => one);
    expect(thrown).toBeInstanceOf(Refused);
    expect(thrown).toMatchObject({
      by: 'gate',
      code: 'not-armed',
      message: 'Arm first.',
      commandId: 'c-12345678',
    });
  });

  it('that changes the speed is over when the vehicle has taken it', async () => {
    ending({});
    await all.drone.changeSpeed(5);
    const { body } = all.server.asked.find(({ what }) => what === GIVE) ?? {};
    expect(body).toMatchObject({ type: 'changeSpeed', metersPerSecond: 5 });
  });

  it('that changes the speed says the range that the vehicle has', async () => {
    const reason = 'metersPerSecond must be 0.2 to 30 for a vehicle of this kind (multicopter), not 40.';
    ending({ result: 'refused', by: 'gate', reason, code: 'speed-not-possible' });
    const thrown = await all.drone.changeSpeed(40).catch((one: unknown) => one);
    expect(thrown).toBeInstanceOf(Refused);
    expect(thrown).toMatchObject({ code: 'speed-not-possible', message: reason });
    ending({ result: 'timedOut', reason: 'No answer within 8 s.' });
    await expect(all.drone.changeSpeed(4)).rejects.toThrow(TimedOut);
  });

  it('that is wrong in itself is a problem', async () => {
    const problem = {
      code: 'value-out-of-range',
      detail: 'Altitude is 900.',
      field: 'altitude',
      allowed: '1 to 500',
    };
    all.server.faults.set(GIVE, [{ status: 422, problem }]);
    const thrown = await all.drone.command({ type: 'takeOff', altitude: 900 }).catch((one: unknown) => one);
    expect(thrown).toBeInstanceOf(Problem);
    expect(thrown).toMatchObject({ status: 422, field: 'altitude', allowed: '1 to 500' });
  });

  it('is given again with the same id while the line breaks or the server is busy, and acts once', async () => {
    const busy = { status: 503, problem: { code: 'busy', retryAfterSeconds: 1 } };
    all.server.faults.set(GIVE, ['answer lost', busy, 'request lost', { ...busy, status: 429 }]);
    const given = vi.fn();
    all.server.onGiven = given;
    const command = await all.drone.command({ type: 'arm' });
    expect(all.server.countOf(GIVE)).toBe(5);
    const ids = all.server.asked.filter(({ what }) => what === GIVE).map(({ body }) => body['id']);
    expect(new Set(ids)).toEqual(new Set([command.id]));
    expect(given).toHaveBeenCalledTimes(1);
  });

  it('of which nobody knows whether it was given is told as such when patience ends', async () => {
    all.server.faults.set(GIVE, Array<'answer lost'>(100).fill('answer lost'));
    const thrown = await all.drone.command({ type: 'arm' }, { timeout: 2_000 }).catch((one: unknown) => one);
    expect(thrown).toBeInstanceOf(OutcomeUnknown);
    expect(String(thrown)).toContain('Whether arm was given is not known');
  });

  it('that a busy server never took is a problem', async () => {
    const busy = { status: 503, problem: { code: 'busy', detail: 'Too busy.', retryAfterSeconds: 60 } };
    all.server.faults.set(GIVE, [busy]);
    await expect(all.drone.command({ type: 'arm' })).rejects.toMatchObject({ status: 503, code: 'busy' });
  });

  it('that ended while the stream was away is asked for', async () => {
    const command = await all.drone.command({ type: 'arm' });
    const outcome = command.outcome();
    await until(() => expect(all.server.listeners).toBe(1));
    all.server.breakLines();
    await until(() => expect(all.server.listeners).toBe(0));
    all.server.setCommand(command.id, { phase: 'done', outcome: succeeded });
    expect((await outcome).id).toBe(command.id);
  });

  it('that the server no longer knows is unknown', async () => {
    const command = await all.drone.command({ type: 'arm' });
    all.server.commands.clear();
    await expect(command.outcome()).rejects.toBeInstanceOf(OutcomeUnknown);
  });

  it('is waited for as long as is asked, or until the signal', async () => {
    const command = await all.drone.command({ type: 'arm' });
    const late = await command.outcome({ timeout: 500 }).catch((one: unknown) => one);
    expect(late).toBeInstanceOf(OutcomeUnknown);
    expect(late).toMatchObject({
      code: 'not-waited-for',
      message: '“arm” has not ended within 0.5 s; it may still do so.',
    });
    const stop = new AbortController();
    const outcome = command.outcome({ signal: stop.signal });
    stop.abort(new Error('landed by hand'));
    await expect(outcome).rejects.toThrow('landed by hand');
  });

  it('is asked for where there is no stream', async () => {
    vi.stubGlobal('WebSocket', undefined);
    const { url } = all.server;
    const deaf = await Dronemap.connect({ url, key: KEY, timers: quickTimers });
    Reflect.deleteProperty(globalThis, 'WebSocket');
    const drone = await deaf.drone('d1');
    const command = await drone.command({ type: 'arm' });
    const outcome = command.outcome();
    await until(() => expect(all.server.countOf(`GET /api/v1/commands/${command.id}`)).toBeGreaterThan(0));
    all.server.setCommand(command.id, { phase: 'done', outcome: succeeded });
    expect((await outcome).phase).toBe('done');
    await expect(drone.waitFor(() => true)).rejects.toThrow('This version of Node has no WebSocket');
    vi.unstubAllGlobals();
  });
});
