import type { BreachAction, NewZone, Zone, ZoneProperties } from '../api/zones';
import type { Coordinates } from '../geo/coordinates';

/** A zone that is being drawn or changed: corners of an area, or the middle of a circle. */
export interface ZoneDraft {
  /** Of the zone that is changed; null: a new one. */
  id: string | null;
  shape: 'polygon' | 'circle';
  points: readonly Coordinates[];
  name: string;
  kind: 'exclusion' | 'inclusion';
  radius: number | null;
  floor: number | null;
  ceiling: number | null;
  altitudeReference: ZoneProperties['altitudeReference'];
  onBreach: BreachAction;
  binds: 'everybody' | 'drone' | 'user';
  /** Only these are bound, where it binds a drone, or a user. */
  drone: string | null;
  user: string;
  /** As an input for date and time has them, in the time of the place; empty: from now on, without end. */
  from: string;
  until: string;
}

export const MOST_CORNERS = 100;

export function newZone(shape: ZoneDraft['shape']): ZoneDraft {
  return {
    id: null,
    shape,
    points: [],
    name: '',
    kind: 'exclusion',
    radius: 100,
    floor: null,
    ceiling: null,
    altitudeReference: 'home',
    onBreach: 'hold',
    binds: 'everybody',
    drone: null,
    user: '',
    from: '',
    until: '',
  };
}

/** A zone as it is, to be changed. */
export function draftOf({ id, geometry, properties }: Zone): ZoneDraft {
  const circle = geometry.type === 'Point';
  const positions =
    geometry.type === 'Point' ? [geometry.coordinates] : (geometry.coordinates[0] ?? []).slice(0, -1);
  return {
    id,
    shape: circle ? 'circle' : 'polygon',
    points: positions.map(([longitude = 0, latitude = 0]) => ({ latitude, longitude })),
    name: properties.name,
    kind: properties.kind,
    radius: properties.radius,
    floor: properties.floor,
    ceiling: properties.ceiling,
    altitudeReference: properties.altitudeReference,
    onBreach: properties.onBreach,
    binds: properties.drone !== null ? 'drone' : properties.user !== null ? 'user' : 'everybody',
    drone: properties.drone,
    user: properties.user ?? '',
    from: local(properties.from),
    until: local(properties.until),
  };
}

function local(iso: string | null): string {
  if (iso === null) {
    return '';
  }
  const moment = new Date(iso);
  return new Date(moment.getTime() - moment.getTimezoneOffset() * 60_000).toISOString().slice(0, 19);
}

function instant(local: string): string | null {
  return local === '' ? null : new Date(local).toISOString();
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

/** The first thing that is missing, as a sentence; null when it can be sent. */
export function missing(draft: ZoneDraft): string | null {
  return (
    missingOfShape(draft) ?? missingOfTerms(draft) ?? (draft.name.trim() === '' ? 'Give it a name.' : null)
  );
}

function missingOfShape(draft: ZoneDraft): string | null {
  if (draft.shape === 'polygon') {
    return draft.points.length < 3
      ? `Click on the map to set the corners: ${draft.points.length} of at least 3.`
      : null;
  }
  if (draft.points.length === 0) {
    return 'Click on the map where the middle is.';
  }
  return draft.radius !== null && draft.radius >= 1 ? null : 'Give the radius, at least 1 m.';
}

function missingOfTerms(draft: ZoneDraft): string | null {
  if (draft.binds === 'drone' && draft.drone === null) {
    return 'Select the drone that it applies to.';
  }
  if (draft.binds === 'user' && draft.user.trim() === '') {
    return 'Enter the user that it applies to.';
  }
  const over = draft.from !== '' && draft.until !== '' && draft.from >= draft.until;
  return over ? 'It must end after it begins.' : null;
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
      altitudeReference: draft.altitudeReference,
      onBreach: draft.onBreach,
      drone: draft.binds === 'drone' ? draft.drone : null,
      user: draft.binds === 'user' ? draft.user.trim() : null,
      from: instant(draft.from),
      until: instant(draft.until),
    },
  };
}
