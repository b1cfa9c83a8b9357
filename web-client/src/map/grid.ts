import type { Feature, FeatureCollection, LineString } from 'geojson';

/** The part of the Earth that the map shows, in degrees. */
export interface View {
  west: number;
  south: number;
  east: number;
  north: number;
  /** Ground metres that one pixel covers. */
  metersPerPixel: number;
}

const METERS_PER_DEGREE = 111_320;
const STEPS_METERS = [10, 20, 50, 100, 200, 500, 1_000, 2_000, 5_000, 10_000];
const LEAST_PIXELS = 70;
const MOST_LINES = 400;

/** The width of a grid square in metres for this view; null when the map shows too much for a grid to help. */
export function gridStep(view: View): number | null {
  return STEPS_METERS.find((step) => step / view.metersPerPixel >= LEAST_PIXELS) ?? null;
}

/** A metric grid that lies still while the map moves: without tiles it is what makes metres visible. */
export function gridLines(view: View): FeatureCollection<LineString> {
  const step = gridStep(view);
  const features: Feature<LineString>[] = [];
  if (step !== null && view.metersPerPixel < 60) {
    // One width a degree of latitude, so that lines do not creep while panning north.
    const anchor = Math.round((view.north + view.south) / 2);
    const down = step / METERS_PER_DEGREE;
    const across = down / Math.max(0.01, Math.cos((anchor * Math.PI) / 180));
    for (const latitude of multiples(view.south, view.north, down)) {
      features.push(line([view.west, latitude], [view.east, latitude]));
    }
    for (const longitude of multiples(view.west, view.east, across)) {
      features.push(line([longitude, view.south], [longitude, view.north]));
    }
  }
  return { type: 'FeatureCollection', features };
}

function multiples(from: number, to: number, step: number): number[] {
  const first = Math.ceil(from / step);
  const count = Math.min(MOST_LINES, Math.max(0, Math.floor(to / step) - first + 1));
  return Array.from({ length: count }, (_, i) => (first + i) * step);
}

function line(from: [number, number], to: [number, number]): Feature<LineString> {
  return { type: 'Feature', properties: {}, geometry: { type: 'LineString', coordinates: [from, to] } };
}
