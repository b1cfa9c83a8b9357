import type { Polygon } from 'geojson';
import { expect, it } from 'vitest';
import { unwrapShape } from './antimeridian';

const polygon = (...ring: [number, number][]): Polygon => ({ type: 'Polygon', coordinates: [ring] });

it('leaves a shape alone that does not cross the edge of the map', () => {
  const shape = polygon([0, 0], [10, 0], [10, 10], [0, 0]);
  expect(unwrapShape(shape)).toEqual(shape);
});

it('runs on past the 180th meridian', () => {
  const shape = polygon([170, 60], [-170, 60], [-170, 70], [170, 70], [170, 60]);
  expect(unwrapShape(shape).coordinates[0]).toEqual([
    [170, 60],
    [190, 60],
    [190, 70],
    [170, 70],
    [170, 60],
  ]);
});

it('closes a ring around the south pole along the pole', () => {
  const ring = unwrapShape(polygon([-170, -70], [0, -70], [170, -70], [-170, -70])).coordinates[0];
  expect(ring?.slice(-4)).toEqual([
    [190, -70],
    [190, -90],
    [-170, -90],
    [-170, -70],
  ]);
});
