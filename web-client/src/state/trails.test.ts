import { describe, expect, it } from 'vitest';
import type { Drone } from '../api/types';
import { aDrone } from '../testing';
import { Trails } from './trails';

/** A drone heard so many seconds after noon, north of 47° by so many hundredths of a minute (18.5 m each). */
function seen(second: number, steps: number): Drone {
  const lastHeard = new Date(Date.UTC(2026, 0, 1, 12, 0, second)).toISOString();
  const latitude = 47 + steps / 6000;
  return aDrone({
    link: { ...aDrone().link, lastHeard },
    position: { latitude, longitude: 8, altitudeAmsl: null, altitudeAboveHome: null },
  });
}

function partsOf(...drones: Drone[]): number[] {
  const trails = new Trails();
  drones.forEach((drone) => trails.add(drone));
  return trails.of('d1').map((part) => part.length);
}

describe('trails', () => {
  it('are one line while the drone is heard', () => {
    expect(partsOf(seen(0, 0), seen(1, 1), seen(4, 2), seen(9, 3))).toEqual([4]);
  });

  it('are broken where the drone was silent for more than five seconds', () => {
    expect(partsOf(seen(0, 0), seen(1, 1), seen(31, 20), seen(32, 21))).toEqual([2, 2]);
  });

  it('stay whole when a drone hovered for long and was heard all the while', () => {
    const hovering = Array.from({ length: 30 }, (_, second) => seen(second, 1));
    expect(partsOf(seen(0, 0), ...hovering, seen(30, 2))).toEqual([3]);
  });

  it('are broken also when a drone is heard again at the same place and flies on', () => {
    expect(partsOf(seen(0, 0), seen(1, 1), seen(20, 1), seen(21, 2), seen(22, 3))).toEqual([2, 2]);
  });

  it('are broken at a step that nothing can fly in one report', () => {
    expect(partsOf(seen(0, 0), seen(1, 1), seen(2, 40), seen(3, 41))).toEqual([2, 2]);
  });

  it('keep the newest 600 points', () => {
    const way = Array.from({ length: 700 }, (_, second) => seen(second, second));
    expect(partsOf(...way)).toEqual([600]);
  });
});
