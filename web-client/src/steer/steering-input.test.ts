import { beforeEach, describe, expect, it } from 'vitest';
import type { Velocity } from '../api/types';
import { NEUTRAL, paceOf } from './axes';
import { SteeringInput, LINK_DOWN } from './steering-input.svelte';

const AHEAD = { ...NEUTRAL, forward: 1 };

describe('the steering input', () => {
  let sent: (Velocity | 'let go')[];
  let runTimer: (() => void) | null;
  let connected: boolean;
  let input: SteeringInput;

  beforeEach(() => {
    sent = [];
    runTimer = null;
    connected = true;
    input = new SteeringInput(
      {
        steer: (velocity) => {
          sent.push(velocity);
          return connected;
        },
        letGo: () => sent.push('let go'),
        every: (_, action) => {
          runTimer = action;
          return () => (runTimer = null);
        },
      },
      paceOf(0.5, true),
    );
  });

  it('sends setpoints while a source is held, and stops with the last one', () => {
    input.hold('keys', AHEAD);
    runTimer?.();
    input.hold('stick', { ...NEUTRAL, turn: 1 });
    runTimer?.();
    expect(sent.map((one) => one !== 'let go' && [one.forward, one.turn])).toEqual([
      [0.5, 0],
      [0.5, 0],
      [0.5, 60],
    ]);
    input.hold('keys', null);
    expect(sent).toHaveLength(3);
    input.hold('stick', null);
    expect(sent.at(-1)).toBe('let go');
    expect(runTimer).toBeNull();
    expect(input.velocity).toBeNull();
  });

  it('counts a source again only after all were released, after a refusal and after Escape', () => {
    input.hold('keys', AHEAD);
    input.refuse('Take off first.');
    expect(sent.at(-1)).toBe('let go');
    input.hold('keys', AHEAD);
    expect(runTimer).toBeNull();
    expect(input.problem).toBe('Take off first.');
    input.hold('keys', null);
    input.hold('keys', AHEAD);
    expect(input.problem).toBeNull();
    input.release();
    input.hold('keys', { ...NEUTRAL, turn: 1 });
    expect(runTimer).toBeNull();
    expect(sent.at(-1)).toBe('let go');
  });

  it('sends nothing without a connection', () => {
    connected = false;
    input.hold('keys', AHEAD);
    expect(input.problem).toBe(LINK_DOWN);
    expect(runTimer).toBeNull();
  });

  it('stops once, and not without input', () => {
    input.hold('keys', null);
    input.release();
    input.clear();
    expect(sent).toEqual([]);
  });

  it('goes on at another pace while it is held', () => {
    input.hold('keys', AHEAD);
    input.pace = paceOf(1, true);
    runTimer?.();
    expect(sent.map((one) => one !== 'let go' && one.forward)).toEqual([0.5, 1]);
  });
});
