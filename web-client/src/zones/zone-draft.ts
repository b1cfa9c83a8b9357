import type { BreachAction, NewZone } from '../api/zones';
import type { Coordinates } from '../geo/coordinates';

/** A zone that is being drawn: corners of an area, or the middle of a circle. */
export interface ZoneDraft {
  shape: 'polygon' | 'circle';
  points: readonly Coordinates[];
  name: string;
  kind: 'exclusion' | 'inclusion';
  radius: number | null;
  floor: number | null;
  ceiling: number | null;
  onBreach: BreachAction;
  /** Binds this drone alone; null: all of them. */
  drone: string | null;
}

export const MOST_CORNERS = 100;

export function newZone(shape: ZoneDraft['shape']): ZoneDraft {
  return {
    shape,
    points: [],
    name: '',
    kind: 'exclusion',
    radius: 100,
    floor: null,
    ceiling: null,
    onBreach: 'hold',
    drone: null,
  };
}

/** The next corner, or another middle. */
export function withPoint(draft: ZoneDraft, place: Coordinates): ZoneDraft {
  if (draft.shape === 'circle') {
    return { ...draft, points: [place] };
  }
  return draft.points.length < MOST_CORNERS ? { ...draft, points: [...draft.points, place] } : draft;
}

export function withoutLastPoint(draft: ZoneDraft): ZoneDraft {
  return { ...draft, points: draft.points.slice(0, -1) };
}

/** What is still missing, as a sentence; null when it can be sent. */
export function missing(draft: ZoneDraft): string | null {
  if (draft.shape === 'circle' && draft.points.length === 0) {
    return 'Click on the map where the middle is.';
  }
  if (draft.shape === 'polygon' && draft.points.length < 3) {
    return `Click on the map to set the corners: ${draft.points.length} of at least 3.`;
  }
  if (draft.shape === 'circle' && !(draft.radius !== null && draft.radius >= 1)) {
    return 'Give the radius, at least 1 m.';
  }
  return draft.name.trim() === '' ? 'Give it a name.' : null;
}

export function featureOf(draft: ZoneDraft): NewZone {
  const positions = draft.points.map((place) => [place.longitude, place.latitude]);
  return {
    type: 'Feature',
    geometry:
      draft.shape === 'circle'
        ? { type: 'Point', coordinates: positions[0] ?? [] }
        : { type: 'Polygon', coordinates: [[...positions, positions[0] ?? []]] },
    properties: {
      name: draft.name.trim(),
      kind: draft.kind,
      radius: draft.shape === 'circle' ? draft.radius : null,
      floor: draft.floor,
      ceiling: draft.ceiling,
      onBreach: draft.onBreach,
      drone: draft.drone,
    },
  };
}
