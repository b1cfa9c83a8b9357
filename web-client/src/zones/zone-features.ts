import type { Feature, FeatureCollection, Position } from 'geojson';
import type { Zone } from '../api/zones';
import type { ZoneDraft } from './zone-draft';

const CIRCLE_CORNERS = 72;
const METERS_PER_DEGREE = 111_195;

/** The part of a zone that is drawn. */
type Area = Pick<Zone, 'geometry'> & { properties: Pick<Zone['properties'], 'name' | 'kind' | 'radius'> };

/** The zones as areas, circles too; across the date line in one piece. */
export function zoneFeatures(zones: readonly Area[]): FeatureCollection {
  return {
    type: 'FeatureCollection',
    features: zones.map((zone) =>
      area(outlineOf(zone), { kind: zone.properties.kind, label: zone.properties.name }),
    ),
  };
}

/** The zone that is being drawn: its points, and its edge as far as there is one. */
export function zoneDraftFeatures(draft: ZoneDraft | null): FeatureCollection {
  const features: Feature[] = [];
  if (draft !== null) {
    const points = draft.points.map((place): Position => [place.longitude, place.latitude]);
    const middle = points[0];
    if (draft.shape === 'circle' && middle !== undefined && draft.radius !== null) {
      features.push(area(circle(middle, draft.radius), {}));
    } else if (points.length > 1) {
      features.push(area(closed(points), {}));
    }
    features.push(
      ...points.map((coordinates): Feature => ({
        type: 'Feature',
        properties: {},
        geometry: { type: 'Point', coordinates },
      })),
    );
  }
  return { type: 'FeatureCollection', features };
}

/** The outline of a zone, for fitting the map. */
export function outlineOf(zone: Area): Position[] {
  return zone.geometry.type === 'Point'
    ? circle(zone.geometry.coordinates, zone.properties.radius ?? 0)
    : closed(zone.geometry.coordinates[0] ?? []);
}

function circle(middle: Position, radius: number): Position[] {
  const [longitude = 0, latitude = 0] = middle;
  const north = radius / METERS_PER_DEGREE;
  const east = north / Math.cos((latitude * Math.PI) / 180);
  return Array.from({ length: CIRCLE_CORNERS + 1 }, (_, index) => {
    const angle = (2 * Math.PI * index) / CIRCLE_CORNERS;
    return [longitude + east * Math.sin(angle), latitude + north * Math.cos(angle)];
  });
}

/** Each corner on the same side of the date line as the first. */
function closed(corners: Position[]): Position[] {
  const [first] = corners;
  if (first === undefined) {
    return [];
  }
  const near = corners.map(([longitude = 0, latitude = 0]): Position => {
    const turns = Math.round((longitude - (first[0] ?? 0)) / 360);
    return [longitude - 360 * turns, latitude];
  });
  return [...near, near[0] as Position];
}

function area(ring: Position[], properties: Record<string, unknown>): Feature {
  return { type: 'Feature', properties, geometry: { type: 'Polygon', coordinates: [ring] } };
}
