import { describe, expect, it } from 'vitest';
import { Desk } from './desk.svelte';

const HERE = { latitude: 47, longitude: 8 };

describe('desk', () => {
  it('makes room for the map when a place is marked on it', () => {
    const desk = new Desk();
    desk.select('d1');
    desk.aim('d1', HERE);
    expect(desk.sheet).toBe('low');
    expect(desk.target).toEqual({ droneId: 'd1', ...HERE });
  });

  it('forgets the marked place with another choice', () => {
    const desk = new Desk();
    desk.select('d1');
    desk.aim('d1', HERE);
    desk.select('d2');
    expect(desk.target).toBeNull();
    expect(desk.sheet).toBe('half');
  });
});
