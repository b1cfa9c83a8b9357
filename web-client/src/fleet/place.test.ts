import { describe, expect, it } from 'vitest';
import { aDrone } from '../testing';
import { localPlaceOf } from './place';

describe('localPlaceOf', () => {
  it('says where a robot is on its own map', () => {
    const drone = aDrone({ local: { x: 1.5, y: -2, z: null, yaw: 90 } });
    expect(localPlaceOf(drone)).toBe('x 1.50 m, y -2.00 m on its own map');
  });

  it('says nothing of a drone without one', () => {
    expect(localPlaceOf(aDrone({}))).toBeNull();
    expect(localPlaceOf(aDrone({ local: null }))).toBeNull();
  });
});
