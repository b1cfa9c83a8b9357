import { describe, expect, it } from 'vitest';
import { Tours } from '../state/tours.svelte';
import { whyNoDrones } from './plan-limits';

describe('the choice of drones for a plan', () => {
  it('is asked for with drones that are named, or with up to so many of the pool, never with both', async () => {
    const bodies: Record<string, unknown>[] = [];
    const calls = {
      ask: (body: Record<string, unknown>) => {
        bodies.push(body);
        return Promise.resolve({ id: 'p1', state: 'finished', result: null, launch: null });
      },
    };
    const tours = new Tours(calls as unknown as ConstructorParameters<typeof Tours>[0]);
    tours.chosen = ['d1'];
    await tours.ask([]);
    tours.ofPool = true;
    tours.upTo = 4;
    await tours.ask([]);
    expect(bodies.map(({ drones, upTo }) => ({ drones, upTo }))).toEqual([
      { drones: ['d1'], upTo: undefined },
      { drones: undefined, upTo: 4 },
    ]);
  });

  it('needs drones, or a number of them from 1 to 100', () => {
    const no = { ofPool: true, upTo: null, chosen: ['d1'] };
    expect(whyNoDrones({ ...no, ofPool: false })).toBeNull();
    expect(whyNoDrones({ ...no, ofPool: false, chosen: [] })).toBe('Choose drones first.');
    expect(whyNoDrones({ ...no, upTo: 100, chosen: [] })).toBeNull();
    for (const upTo of [null, 0, 101, 1.5]) {
      expect(whyNoDrones({ ...no, upTo })).toContain('1 to 100');
    }
  });
});
