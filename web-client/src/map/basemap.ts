import type { Feature, FeatureCollection, MultiPolygon, Point, Polygon, Position } from 'geojson';
import { feature } from 'topojson-client';
import type { Topology } from 'topojson-specification';
import { unwrapShape } from './antimeridian';
import countriesAddress from 'world-atlas/countries-50m.json?url';

/** The world as it ships: shapes of the countries and a point for the name of each. From Natural Earth. */
export interface World {
  countries: FeatureCollection;
  names: FeatureCollection<Point>;
}

export async function loadWorld(): Promise<World> {
  const response = await fetch(countriesAddress);
  if (!response.ok) {
    throw new Error(`The base map did not load: status ${response.status}.`);
  }
  const topology = (await response.json()) as Topology;
  const shapes = topology.objects['countries'];
  if (shapes === undefined) {
    throw new Error('The base map holds no countries.');
  }
  const raw = feature(topology, shapes) as FeatureCollection<Polygon | MultiPolygon>;
  const countries = {
    ...raw,
    features: raw.features.map((country) => ({ ...country, geometry: unwrapShape(country.geometry) })),
  };
  return { countries, names: { type: 'FeatureCollection', features: countries.features.flatMap(nameOf) } };
}

function nameOf(country: Feature<Polygon | MultiPolygon>): Feature<Point>[] {
  const outlines =
    country.geometry.type === 'Polygon'
      ? [country.geometry.coordinates[0]]
      : country.geometry.coordinates.map((polygon) => polygon[0]);
  const rings = outlines.filter((ring): ring is Position[] => ring !== undefined);
  const largest = rings.reduce((best, ring) => (areaOf(ring) > areaOf(best) ? ring : best), rings[0] ?? []);
  const size = areaOf(largest);
  if (size === 0) {
    return [];
  }
  return [
    {
      type: 'Feature',
      properties: { name: String(country.properties?.['name'] ?? ''), size },
      geometry: { type: 'Point', coordinates: centreOf(largest) },
    },
  ];
}

/** In square degrees: good enough to say which label matters more. */
function areaOf(ring: Position[]): number {
  return Math.abs(fold(ring, (x0, y0, x1, y1) => x0 * y1 - x1 * y0)) / 2;
}

function centreOf(ring: Position[]): Position {
  const twice = fold(ring, (x0, y0, x1, y1) => x0 * y1 - x1 * y0);
  const x = fold(ring, (x0, y0, x1, y1) => (x0 + x1) * (x0 * y1 - x1 * y0));
  const y = fold(ring, (x0, y0, x1, y1) => (y0 + y1) * (x0 * y1 - x1 * y0));
  return [x / (3 * twice), y / (3 * twice)];
}

function fold(ring: Position[], term: (x0: number, y0: number, x1: number, y1: number) => number): number {
  let sum = 0;
  for (let i = 1; i < ring.length; i++) {
    const [x0 = 0, y0 = 0] = ring[i - 1] ?? [];
    const [x1 = 0, y1 = 0] = ring[i] ?? [];
    sum += term(x0, y0, x1, y1);
  }
  return sum;
}
