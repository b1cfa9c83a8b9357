import type { AccessKeyRequest, KeyArea, KeyBounds } from '../api/access-keys';
import type { Zone } from '../api/zones';

/** The bounds in the form. `area`: nothing, the id of a zone, or GeoJSON that was pasted. */
export interface BoundsDraft {
  from: 'everywhere' | 'zone' | 'text';
  zone: string;
  text: string;
  floor: number | null;
  ceiling: number | null;
  altitudeReference: 'home' | 'amsl';
}

export function unbounded(): BoundsDraft {
  return { from: 'everywhere', zone: '', text: '', floor: null, ceiling: null, altitudeReference: 'home' };
}

/** The part of a request that says where and how high; throws an Error with a sentence for who filled in the form. */
export function boundsRequest(draft: BoundsDraft, zones: readonly Zone[]): Partial<AccessKeyRequest> {
  const area = areaOf(draft, zones);
  const { floor, ceiling, altitudeReference } = draft;
  return {
    ...(area === null ? {} : { area }),
    ...(floor === null ? {} : { floor }),
    ...(ceiling === null ? {} : { ceiling }),
    ...(floor === null && ceiling === null ? {} : { altitudeReference }),
  };
}

function areaOf(draft: BoundsDraft, zones: readonly Zone[]): KeyArea | null {
  if (draft.from === 'everywhere') {
    return null;
  }
  if (draft.from === 'text') {
    return pasted(draft.text);
  }
  const zone = zones.find(({ id }) => id === draft.zone);
  if (zone === undefined) {
    throw new Error('Choose the zone that flights stay in.');
  }
  return geometry(zone);
}

/** A geometry, a feature, or a collection of one. What the geometry means, the server judges. */
function pasted(text: string): KeyArea {
  let parsed: unknown;
  try {
    parsed = JSON.parse(text);
  } catch {
    throw new Error('The area is not JSON; paste a polygon, or a point with a radius, as GeoJSON.');
  }
  return geometry(parsed);
}

function geometry(of: unknown): KeyArea {
  if (!isObject(of) || typeof of['type'] !== 'string') {
    throw new Error('The area has no type; paste a polygon, or a point with a radius, as GeoJSON.');
  }
  if (of['type'] === 'FeatureCollection') {
    const features: unknown = of['features'];
    if (!Array.isArray(features) || features.length !== 1) {
      throw new Error('An area is one feature; paste that one alone.');
    }
    return geometry(features[0]);
  }
  if (of['type'] === 'Feature') {
    const inner = geometry(of['geometry']);
    const radius: unknown = isObject(of['properties']) ? of['properties']['radius'] : undefined;
    return inner.type === 'Point' && typeof radius === 'number' ? { ...inner, radius } : inner;
  }
  const radius = of['radius'];
  const { type, coordinates } = of;
  // The cloud has a sentence for what it does not take.
  return { type, coordinates, ...(typeof radius === 'number' ? { radius } : {}) } as KeyArea;
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null;
}

/** The bounds of a key in a few words; empty when it has none. */
export function boundsText({ area, floor, ceiling, altitudeReference }: KeyBounds): string {
  const parts: string[] = [];
  if (area !== null) {
    parts.push(area.type === 'Point' ? `within ${area.radius ?? 0} m of a place` : 'within an area');
  }
  const above = altitudeReference === 'amsl' ? 'above sea level' : 'above home';
  if (floor !== null && ceiling !== null) {
    parts.push(`${floor} to ${ceiling} m ${above}`);
  } else if (ceiling !== null) {
    parts.push(`up to ${ceiling} m ${above}`);
  } else if (floor !== null) {
    parts.push(`from ${floor} m ${above} upwards`);
  }
  return parts.join(', ');
}
