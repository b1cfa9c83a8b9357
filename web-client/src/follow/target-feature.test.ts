import type { Feature } from 'geojson';
import { describe, expect, it } from 'vitest';
import { distanceMeters } from '../geo/distance';
import { aFollow, aFollowNow } from '../testing';
import { DEMO_NAME } from './following';
import { followFeatures } from './target-feature';

const HEARD = '2026-01-01T12:00:00Z';
const drone = { latitude: 47.3978, longitude: 8.5456 };
const shown = (seconds: number, change: Parameters<typeof aFollow>[0] = {}): Feature[] =>
  followFeatures(
    [aFollow({ state: 'tracking', now: aFollowNow(HEARD), ...change })],
    Date.parse(HEARD) + seconds * 1000,
    () => drone,
  ).features;
const of = (features: Feature[], type: string): Feature | undefined =>
  features.find(({ geometry }) => geometry.type === type);

describe('whoever is followed, on the map', () => {
  it('has a name, a line to the drone, and a circle as wide as its place is unsure', () => {
    const features = shown(1);
    const point = of(features, 'Point');
    expect(point?.properties).toMatchObject({ id: 'd1', label: 'olga', tone: 'green', age: '' });
    expect(of(features, 'LineString')?.geometry).toMatchObject({
      coordinates: [
        [8.5456, 47.3978],
        [8.5456, 47.3979],
      ],
    });
    const ring = of(features, 'Polygon')?.geometry;
    const corners = ring?.type === 'Polygon' ? (ring.coordinates[0] ?? []) : [];
    const center = { latitude: 47.3979, longitude: 8.5456 };
    expect(corners.length).toBeGreaterThan(30);
    corners.forEach(([longitude = 0, latitude = 0]) =>
      expect(distanceMeters(center, { latitude, longitude })).toBeCloseTo(5, 1),
    );
    expect(corners[0]).toEqual(corners.at(-1));
  });

  it('turns amber and says how old its place is when the phone is silent', () => {
    expect(of(shown(12), 'Point')?.properties).toMatchObject({ tone: 'amber', age: '12 s ago' });
    expect(of(shown(1, { note: 'A zone is in its way.' }), 'Point')?.properties).toMatchObject({
      tone: 'amber',
    });
    expect(of(shown(12, { state: 'paused' }), 'Point')?.properties).toMatchObject({ tone: 'neutral' });
  });

  it('is said to be a demo walk, and not shown where nobody knows where it is', () => {
    expect(of(shown(1, { name: DEMO_NAME }), 'Point')?.properties?.['label']).toContain('demo walk');
    expect(shown(1, { now: null })).toEqual([]);
  });
});
