import type { MultiPolygon, Polygon, Position } from 'geojson';

/**
 * Lets a shape that crosses the 180th meridian run on past it instead of jumping around the world, and closes a ring
 * around a pole along that pole. The map wraps what lies beyond its edge by itself.
 */
export function unwrapShape(shape: Polygon | MultiPolygon): Polygon | MultiPolygon {
  return shape.type === 'Polygon'
    ? { ...shape, coordinates: unwrapPolygon(shape.coordinates) }
    : { ...shape, coordinates: shape.coordinates.map(unwrapPolygon) };
}

function unwrapPolygon(rings: Position[][]): Position[][] {
  return rings.map(unwrapRing);
}

function unwrapRing(ring: Position[]): Position[] {
  let shift = 0;
  let before: number | null = null;
  const unwrapped = ring.map(([longitude = 0, latitude = 0]): Position => {
    if (before !== null) {
      const jump = longitude - before;
      shift += jump > 180 ? -360 : jump < -180 ? 360 : 0;
    }
    before = longitude;
    return [longitude + shift, latitude];
  });
  return shift === 0 ? unwrapped : closeAroundPole(unwrapped);
}

function closeAroundPole(ring: Position[]): Position[] {
  const [first, last] = [ring[0], ring.at(-1)];
  if (first === undefined || last === undefined) {
    return ring;
  }
  const pole = (first[1] ?? 0) < 0 ? -90 : 90;
  return [...ring, [last[0] ?? 0, pole], [first[0] ?? 0, pole], first];
}
