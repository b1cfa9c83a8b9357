import { describe, expect, it, vi } from 'vitest';
import { Problem } from '../api/problem';
import type { Command } from '../api/types';
import { aCommand } from '../testing';
import { Commands } from './commands.svelte';

type Port = ConstructorParameters<typeof Commands>[0];

function following(port: Partial<Port>, onSuccess = vi.fn()): Commands {
  let next = 0;
  const whole: Port = {
    sendCommand: async (drone, request) => aCommand({ id: request.id, drone, type: request.type }),
    command: async (id) => aCommand({ id }),
    commandsOf: async () => [],
    ...port,
  };
  return new Commands(whole, () => `c${++next}`, onSuccess);
}

const done = (change: Partial<Command> = {}): Command =>
  aCommand({
    phase: 'done',
    outcome: { result: 'succeeded', by: 'vehicle', reason: null, code: null },
    ...change,
  });

describe('commands', () => {
  it('follows a press from sent over accepted to done', async () => {
    const onSuccess = vi.fn();
    const commands = following({}, onSuccess);
    await commands.send('d1', { type: 'arm' });
    expect(commands.attempt('d1', 'arm')?.phase).toBe('sent');
    commands.apply(aCommand({ phase: 'accepted' }));
    expect(commands.attempt('d1', 'arm')?.phase).toBe('accepted');
    commands.apply(done());
    commands.apply(done());
    expect(commands.attempt('d1', 'arm')?.outcome?.result).toBe('succeeded');
    expect(onSuccess).toHaveBeenCalledTimes(1);
  });

  it('does not fall back when the answer comes later than the stream', async () => {
    let answer: (command: Command) => void = () => undefined;
    const commands = following({ sendCommand: () => new Promise((resolve) => (answer = resolve)) });
    const sending = commands.send('d1', { type: 'arm' });
    commands.apply(done());
    answer(aCommand({ phase: 'sent' }));
    await sending;
    expect(commands.attempt('d1', 'arm')?.phase).toBe('done');
    expect(commands.history.get('d1')?.[0]?.phase).toBe('done');
  });

  it('shows the sentence of the gate as a refusal', async () => {
    const refusal = new Problem({ status: 409, detail: 'Arm first.', code: 'not-armed', commandId: 'c1' });
    const commands = following({ sendCommand: () => Promise.reject(refusal) });
    const attempt = await commands.send('d1', { type: 'takeOff', altitude: 20 });
    expect(attempt).toMatchObject({
      phase: 'done',
      problem: null,
      outcome: { result: 'refused', by: 'gate', reason: 'Arm first.', code: 'not-armed' },
    });
  });

  it('says that nothing was sent when the cloud did not take it', async () => {
    const commands = following({ sendCommand: () => Promise.reject(Problem.unreachable()) });
    const attempt = await commands.send('d1', { type: 'land' });
    expect(attempt.problem).toContain('did not answer');
    expect(attempt.outcome).toBeNull();
  });

  it('keeps the commands of other people in the history but out of my controls', () => {
    const commands = following({});
    commands.apply(aCommand({ id: 'foreign', by: 'bob' }));
    expect(commands.attempt('d1', 'arm')).toBeNull();
    expect(commands.history.get('d1')).toHaveLength(1);
  });

  it('asks for what may have ended while the stream was down', async () => {
    const commands = following({ command: async (id) => done({ id }) });
    await commands.send('d1', { type: 'arm' });
    await commands.catchUp();
    expect(commands.attempt('d1', 'arm')?.phase).toBe('done');
  });

  it('keeps the newest fifty of each drone', () => {
    const commands = following({});
    for (let i = 0; i < 60; i++) {
      commands.apply(aCommand({ id: `x${i}` }));
    }
    expect(commands.history.get('d1')).toHaveLength(50);
    expect(commands.history.get('d1')?.[0]?.id).toBe('x59');
  });
});
