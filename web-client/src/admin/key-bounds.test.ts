import { describe, expect, it } from 'vitest';
import type { Zone } from '../api/zones';
import { boundsText, boundsRequest, unbounded } from './key-bounds';

const POINT = { type: 'Point' as const, coordinates: [8.5, 47.4] };

const ZONE = {
  type: 'Feature',
  id: 'z1',
  geometry: POINT,
  properties: { name: 'Field', kind: 'inclusion', radius: 300 },
} as unknown as Zone;

describe('the bounds of a key', () => {
  it('are left out when there are none', () => {
    expect(boundsRequest(unbounded(), [])).toEqual({});
  });

  it('come from a zone', () => {
    expect(boundsRequest({ ...unbounded(), from: 'zone', zone: 'z1', ceiling: 50 }, [ZONE])).toEqual({
      area: { ...POINT, radius: 300 },
      ceiling: 50,
      altitudeReference: 'home',
    });
    expect(() => boundsRequest({ ...unbounded(), from: 'zone' }, [ZONE])).toThrow('Choose the zone');
  });

  it('come from pasted GeoJSON: a geometry, a feature, or a collection of one', () => {
    const draft = (of: unknown) => ({ ...unbounded(), from: 'text' as const, text: JSON.stringify(of) });
    const area = { ...POINT, radius: 300 };

    expect(boundsRequest(draft(area), [])).toEqual({ area });
    expect(boundsRequest(draft(ZONE), [])).toEqual({ area });
    expect(boundsRequest(draft({ type: 'FeatureCollection', features: [ZONE] }), [])).toEqual({ area });
  });

  it('say what is wrong with what was pasted', () => {
    const draft = (text: string) => ({ ...unbounded(), from: 'text' as const, text });

    expect(() => boundsRequest(draft('<kml/>'), [])).toThrow('not JSON');
    expect(() => boundsRequest(draft('7'), [])).toThrow('no type');
    expect(() => boundsRequest(draft('{"type":"Feature"}'), [])).toThrow('no type');
    expect(() => boundsRequest(draft('{"type":"FeatureCollection","features":[]}'), [])).toThrow(
      'one feature',
    );
  });

  it('are shown in a few words', () => {
    const none = { area: null, floor: null, ceiling: null, altitudeReference: null };

    expect(boundsText(none)).toBe('');
    expect(
      boundsText({ ...none, area: { ...POINT, radius: 300 }, ceiling: 50, altitudeReference: 'home' }),
    ).toBe('within 300 m of a place, up to 50 m above home');
    expect(
      boundsText({
        area: { type: 'Polygon', coordinates: [] },
        floor: 400,
        ceiling: 500,
        altitudeReference: 'amsl',
      }),
    ).toBe('within an area, 400 to 500 m above sea level');
    expect(boundsText({ ...none, floor: 10, altitudeReference: 'home' })).toBe(
      'from 10 m above home upwards',
    );
  });
});
