import { describe, expect, it } from 'vitest';
import { aDrone } from '../testing';
import { Fleet } from './fleet.svelte';

describe('fleet', () => {
  const now = (action: () => void): void => action();

  it('lists drones by name, with numbers as people count', () => {
    const fleet = new Fleet(now);
    fleet.replaceAll([aDrone({ id: 'b', name: 'Copter 10' }), aDrone({ id: 'a', name: 'Copter 2' })]);
    expect(fleet.drones.map((drone) => drone.name)).toEqual(['Copter 2', 'Copter 10']);
    expect(fleet.loaded).toBe(true);
  });

  it('forgets drones that a whole list no longer holds', () => {
    const fleet = new Fleet(now);
    fleet.replaceAll([aDrone({ id: 'a' }), aDrone({ id: 'b' })]);
    fleet.replaceAll([aDrone({ id: 'b' })]);
    expect(fleet.find('a')).toBeNull();
    expect(fleet.find('b')).not.toBeNull();
  });

  it('ignores news older than what it knows', () => {
    const fleet = new Fleet(now);
    fleet.update(aDrone({ version: 5, mode: 'AUTO' }));
    fleet.update(aDrone({ version: 4, mode: 'LOITER' }));
    expect(fleet.find('d1')?.mode).toBe('AUTO');
  });

  it('takes any version after a restart of the cloud, when a whole list comes', () => {
    const fleet = new Fleet(now);
    fleet.update(aDrone({ version: 500, mode: 'AUTO' }));
    fleet.replaceAll([aDrone({ version: 1, mode: 'LOITER' })]);
    expect(fleet.find('d1')?.mode).toBe('LOITER');
  });

  it('redraws once for many pieces of news', () => {
    const waiting: (() => void)[] = [];
    const fleet = new Fleet((action) => waiting.push(action));
    for (let version = 1; version <= 100; version++) {
      fleet.update(aDrone({ version }));
    }
    expect(waiting).toHaveLength(1);
    waiting[0]?.();
    expect(fleet.find('d1')?.version).toBe(100);
  });

  it('draws a trail of where a drone has been, without steps smaller than a metre', () => {
    const fleet = new Fleet(now);
    const at = (latitude: number) => ({
      latitude,
      longitude: 8,
      altitudeAmsl: null,
      altitudeAboveHome: null,
    });
    fleet.update(aDrone({ version: 1, position: at(47) }));
    fleet.update(aDrone({ version: 2, position: at(47.000001) }));
    fleet.update(aDrone({ version: 3, position: at(47.001) }));
    expect(fleet.trails.of('d1')).toEqual([
      [
        [8, 47],
        [8, 47.001],
      ],
    ]);
    fleet.update(aDrone({ version: 4, position: at(46) }));
    expect(fleet.trails.of('d1')).toEqual([[[8, 46]]]);
    fleet.remove('d1');
    expect(fleet.trails.of('d1')).toEqual([]);
  });
});
