import { beforeEach, describe, expect, it } from 'vitest';
import type { Coordinates } from '../geo/coordinates';
import { CLOSEST_ZOOM, AutoFit, LEFT_ALONE_MILLISECONDS, type Viewport } from './auto-fit';

/** A map whose pixels are metres east and north, 390 wide and 240 high. */
class Flat implements Viewport {
  level = 14;
  readonly shows = ({ latitude, longitude }: Coordinates): boolean =>
    longitude >= 0 && longitude <= 390 && latitude >= 0 && latitude <= 240;
  readonly pixelOf = ({ latitude, longitude }: Coordinates) => ({ x: longitude, y: latitude });
  readonly size = () => ({ width: 390, height: 240 });
  readonly zoom = (): number => this.level;
}

const at = (longitude: number, latitude: number): Coordinates => ({ latitude, longitude });
const me = at(100, 100);

describe('a map that keeps person and drone in sight', () => {
  let map: Flat;
  let autoFit: AutoFit;
  const isDue = (places: Coordinates[], now = 0): boolean => autoFit.isDue(map, places, now);

  beforeEach(() => {
    map = new Flat();
    autoFit = new AutoFit();
  });

  it('is fitted when there is one more to see, as after a reload, and never to nobody', () => {
    expect(isDue([])).toBe(false);
    expect(isDue([me])).toBe(true);
    expect(isDue([me])).toBe(false);
    expect(isDue([me, at(250, 100)])).toBe(true);
    expect(isDue([])).toBe(false);
  });

  it('is fitted when one is out of sight or at the edge, or both are small together', () => {
    isDue([me, me]);
    expect(isDue([me, at(250, 100)])).toBe(false);
    expect(isDue([me, at(110, 170)])).toBe(false);
    expect(isDue([me, at(400, 100)])).toBe(true);
    expect(isDue([me, at(350, 100)])).toBe(false);
    expect(isDue([me, at(360, 100)])).toBe(true);
    expect(isDue([me, at(110, 110)])).toBe(true);
  });

  it('is not drawn nearer than shows some metres', () => {
    isDue([me, me]);
    map.level = CLOSEST_ZOOM;
    expect(isDue([me, at(110, 110)])).toBe(false);
  });

  it('is left alone for a while when somebody moved it', () => {
    isDue([me, me]);
    autoFit.movedByUser(1_000);
    expect(isDue([me, at(400, 100)], 2_000)).toBe(false);
    expect(isDue([me, at(110, 110)], LEFT_ALONE_MILLISECONDS)).toBe(false);
    expect(isDue([me, at(400, 100)], 1_000 + LEFT_ALONE_MILLISECONDS)).toBe(true);
  });
});
