import { describe, expect, it, vi } from 'vitest';
import { ZoneCalls, type Zone } from '../api/zones';
import { Zones } from '../state/zones.svelte';
import { aZone, operationsBy } from '../testing';
import { draftOf, featureOf, missing, newZone, withoutLastPoint, withPoint } from './zone-draft';
import { outlineOf, zoneDraftFeatures, zoneFeatures } from './zone-features';
import { zoneText } from './zone-text';

const HERE = { latitude: 47, longitude: 8 };

describe('a zone that is drawn', () => {
  it('says what is still missing', () => {
    let draft = newZone('polygon');
    expect(missing(draft)).toContain('0 of at least 3');
    for (const longitude of [8, 8.1, 8.2]) {
      draft = withPoint(draft, { latitude: 47 + longitude / 10, longitude });
    }
    expect(missing(draft)).toBe('Give it a name.');
    expect(missing({ ...draft, name: 'School' })).toBeNull();
    expect(missing(withoutLastPoint(draft))).toContain('2 of at least 3');
    expect(missing({ ...withPoint(newZone('circle'), HERE), radius: null })).toContain('radius');
  });

  it('becomes a closed ring, or a point with a radius', () => {
    const circle = featureOf({ ...withPoint(newZone('circle'), HERE), name: ' Park ', ceiling: 60 });
    expect(circle.geometry).toEqual({ type: 'Point', coordinates: [8, 47] });
    expect(circle.properties).toMatchObject({ name: 'Park', radius: 100, ceiling: 60, kind: 'exclusion' });
    const three = [HERE, { latitude: 47.1, longitude: 8 }, { latitude: 47, longitude: 8.1 }];
    const area = featureOf({ ...newZone('polygon'), points: three });
    expect(area.geometry.coordinates).toEqual([
      [
        [8, 47],
        [8, 47.1],
        [8.1, 47],
        [8, 47],
      ],
    ]);
  });

  it('says whom it binds and when', () => {
    const named = { ...withPoint(newZone('circle'), HERE), name: 'Park' };
    expect(missing({ ...named, binds: 'drone' })).toBe('Select the drone that it applies to.');
    expect(missing({ ...named, binds: 'user', user: ' ' })).toBe('Enter the user that it applies to.');
    expect(missing({ ...named, from: '2026-05-04T12:00', until: '2026-05-04T11:00' })).toContain('end after');
    const timed = featureOf({ ...named, binds: 'user', user: ' bob ', from: '2026-05-04T12:00' }).properties;
    expect(timed).toMatchObject({ user: 'bob', drone: null, until: null });
    expect(timed.from).toBe(new Date('2026-05-04T12:00').toISOString());
  });

  it('is changed from what it is', () => {
    const area: Zone = {
      ...aZone({
        name: 'Airport',
        radius: null,
        ceiling: 600,
        altitudeReference: 'amsl',
        drone: 'drone-1',
        until: '2026-05-04T10:00:30.000Z',
        onBreach: 'land',
      }),
      geometry: {
        type: 'Polygon',
        coordinates: [
          [
            [8, 47],
            [8, 47.1],
            [8.1, 47],
            [8, 47],
          ],
        ],
      },
    };
    for (const zone of [area, aZone({ user: 'bob' })]) {
      const draft = draftOf(zone);
      expect(draft.id).toBe('z1');
      expect(zone).toMatchObject(featureOf(draft));
    }
  });

  it('moves the middle of a circle with each click', () => {
    const draft = withPoint(withPoint(newZone('circle'), HERE), { latitude: 48, longitude: 9 });
    expect(draft.points).toEqual([{ latitude: 48, longitude: 9 }]);
  });
});

describe('a zone on the map', () => {
  it('draws circles as areas of their size', () => {
    const north = Math.max(...outlineOf(aZone()).map(([, latitude = 0]) => latitude));
    expect((north - 47) * 111_195).toBeCloseTo(100, 3);
    expect(zoneFeatures([aZone()]).features[0]?.properties).toEqual({ kind: 'exclusion', label: 'School' });
  });

  it('keeps an area in one piece across the date line', () => {
    const zone: Zone = {
      ...aZone(),
      geometry: {
        type: 'Polygon',
        coordinates: [
          [
            [179.9, -17],
            [-179.9, -17],
            [-179.9, -16],
            [179.9, -17],
          ],
        ],
      },
    };
    expect(outlineOf(zone)[1]?.[0]).toBeCloseTo(180.1, 6);
  });

  it('shows what is drawn so far', () => {
    expect(zoneDraftFeatures(null).features).toHaveLength(0);
    expect(zoneDraftFeatures(withPoint(newZone('polygon'), HERE)).features).toHaveLength(1);
    expect(zoneDraftFeatures(withPoint(newZone('circle'), HERE)).features).toHaveLength(2);
  });
});

describe('the list of zones', () => {
  it('says in one line what a zone means', () => {
    expect(zoneText(aZone(), () => null)).toBe('keep out · at any height · on breach hold');
    expect(
      zoneText(
        aZone({ kind: 'inclusion', floor: 10, ceiling: 60, drone: 'd1', onBreach: 'land' }),
        () => 'Eagle',
      ),
    ).toBe('stay in · 10 to 60 m above home · only Eagle · on breach land');
  });

  it('follows what the cloud says', () => {
    const zones = new Zones(new ZoneCalls(operationsBy(vi.fn())));
    zones.apply(aZone({ name: 'B' }));
    zones.apply({ ...aZone({ name: 'A' }), id: 'z2' });
    zones.apply(aZone({ name: 'C' }));
    expect(zones.all.map((zone) => zone.properties.name)).toEqual(['A', 'C']);
    zones.applyRemoval('z2');
    expect(zones.all).toHaveLength(1);
  });

  it('keeps the draft when the cloud refuses it, and says why', async () => {
    const zones = new Zones(new ZoneCalls(operationsBy(() => Promise.reject(new Error('no')))));
    zones.draft = withPoint(newZone('circle'), HERE);
    await zones.save();
    expect(zones.draft).not.toBeNull();
    expect(zones.problem).not.toBeNull();
  });
});
