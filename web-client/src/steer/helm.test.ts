import { beforeEach, describe, expect, it } from 'vitest';
import type { Velocity } from '../api/types';
import { NEUTRAL, paceOf } from './axes';
import { Helm, LINE_DOWN } from './helm.svelte';

const AHEAD = { ...NEUTRAL, forward: 1 };

describe('helm', () => {
  let said: (Velocity | 'let go')[];
  let tick: (() => void) | null;
  let lineUp: boolean;
  let helm: Helm;

  beforeEach(() => {
    said = [];
    tick = null;
    lineUp = true;
    helm = new Helm(
      {
        steer: (velocity) => {
          said.push(velocity);
          return lineUp;
        },
        letGo: () => said.push('let go'),
        every: (_, action) => {
          tick = action;
          return () => (tick = null);
        },
      },
      paceOf(0.5, true),
    );
  });

  it('says speeds as long as a hand holds something, and lets go with the last one', () => {
    helm.hold('keys', AHEAD);
    tick?.();
    helm.hold('stick', { ...NEUTRAL, turn: 1 });
    tick?.();
    expect(said.map((one) => one !== 'let go' && [one.forward, one.turn])).toEqual([
      [0.5, 0],
      [0.5, 0],
      [0.5, 60],
    ]);
    helm.hold('keys', null);
    expect(said).toHaveLength(3);
    helm.hold('stick', null);
    expect(said.at(-1)).toBe('let go');
    expect(tick).toBeNull();
    expect(helm.saying).toBeNull();
  });

  it('wants all hands off before they count again, after a no and after Escape', () => {
    helm.hold('keys', AHEAD);
    helm.refuse('Take off first.');
    expect(said.at(-1)).toBe('let go');
    helm.hold('keys', AHEAD);
    expect(tick).toBeNull();
    expect(helm.problem).toBe('Take off first.');
    helm.hold('keys', null);
    helm.hold('keys', AHEAD);
    expect(helm.problem).toBeNull();
    helm.release();
    helm.hold('keys', { ...NEUTRAL, turn: 1 });
    expect(tick).toBeNull();
    expect(said.at(-1)).toBe('let go');
  });

  it('says nothing into a line that is down', () => {
    lineUp = false;
    helm.hold('keys', AHEAD);
    expect(helm.problem).toBe(LINE_DOWN);
    expect(tick).toBeNull();
  });

  it('lets go once, and not of what it does not hold', () => {
    helm.hold('keys', null);
    helm.release();
    helm.clear();
    expect(said).toEqual([]);
  });

  it('goes on at another pace while it is held', () => {
    helm.hold('keys', AHEAD);
    helm.pace = paceOf(1, true);
    tick?.();
    expect(said.map((one) => one !== 'let go' && one.forward)).toEqual([0.5, 1]);
  });
});
