import { expect, it } from 'vitest';
import { distanceMeters, wayLengthMeters } from './distance';

it('measures one degree of latitude as 111.195 km', () => {
  expect(distanceMeters({ latitude: 47, longitude: 8 }, { latitude: 48, longitude: 8 })).toBeCloseTo(
    111_195,
    -1,
  );
});

it('adds up a way, and one point is no way', () => {
  const a = { latitude: 0, longitude: 0 };
  const b = { latitude: 0, longitude: 0.001 };
  expect(wayLengthMeters([a, b, a])).toBeCloseTo(2 * distanceMeters(a, b), 6);
  expect(wayLengthMeters([a])).toBe(0);
});
