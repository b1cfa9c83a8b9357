import { describe, expect, it } from 'vitest';
import { frameOf, hitsOf, newestOf, NOTHING_YET, Projection } from './own-map';

const at = '2026-01-01T12:00:00Z';
const local = { x: 1, y: 2, z: null, yaw: 90 };

describe('hitsOf', () => {
  it('turns rays with the vehicle, counter-clockwise', () => {
    const scan = { number: 1, at, firstAngle: -90, angleStep: 90, ranges: [2, 3, 4] };
    const [right, ahead, left] = hitsOf(scan, local);
    expect(right?.x).toBeCloseTo(3);
    expect(right?.y).toBeCloseTo(2);
    expect(ahead?.x).toBeCloseTo(1);
    expect(ahead?.y).toBeCloseTo(5);
    expect(left?.x).toBeCloseTo(-3);
  });

  it('leaves out what was not met, and all where nobody knows how it stands', () => {
    const scan = { number: 1, at, firstAngle: 0, angleStep: 1, ranges: [null, 1, null] };
    expect(hitsOf(scan, local)).toHaveLength(1);
    expect(hitsOf(scan, { ...local, yaw: null })).toEqual([]);
    expect(hitsOf(scan, null)).toEqual([]);
    expect(hitsOf(null, local)).toEqual([]);
  });
});

describe('frameOf', () => {
  it('is the map, or all that was met around the vehicle', () => {
    const map = { number: 3, left: -10, bottom: -5, width: 20, height: 10 };
    expect(frameOf(map, local, [])).toEqual({ left: -10, bottom: -5, width: 20, height: 10 });
    const around = frameOf(null, local, [{ x: 1, y: 12 }]);
    expect(around.bottom + around.height).toBeGreaterThan(12);
    expect(around.left + around.width / 2).toBeCloseTo(1);
    expect(frameOf(null, null, []).width).toBeGreaterThan(1);
  });
});

describe('Projection', () => {
  it('has y upwards and goes both ways', () => {
    const projection = new Projection({ left: -10, bottom: -10, width: 20, height: 20 }, 400, 400);
    expect(projection.toPixels({ x: -10, y: 10 })).toEqual({ x: 0, y: 0 });
    expect(projection.toPixels({ x: 0, y: -10 })).toEqual({ x: 200, y: 400 });
    expect(projection.toMeters(projection.toPixels({ x: 3, y: -7 }))).toEqual({ x: 3, y: -7 });
  });
});

describe('newestOf', () => {
  it('is another word only when a sensor brought something new', () => {
    const numbers = { scan: 4, picture: null, map: 1 };
    expect(newestOf(numbers)).toBe(newestOf({ ...numbers }));
    expect(newestOf(numbers)).not.toBe(newestOf({ ...numbers, picture: 1 }));
    expect(newestOf({ scan: null, picture: null, map: null })).toBe(NOTHING_YET);
    expect(newestOf(null)).toBe(NOTHING_YET);
    expect(newestOf(undefined)).toBe(NOTHING_YET);
  });
});
