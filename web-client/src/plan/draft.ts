import type { AltitudeReference, MissionItem, PlannedItem, WaypointItem } from '../api/types';
import { parseCoordinateLines, type Coordinates } from '../geo/coordinates';
import { wayLengthMeters } from '../geo/distance';
import { landItem, landingOf, type DraftLanding } from './landing';

export type Ending = 'hold' | 'returnToLaunch' | 'land';

/** A waypoint of a plan; the key stays the same while it is moved through the list. Altitude in metres. */
export interface DraftWaypoint extends Coordinates {
  key: number;
  altitude: number | null;
  altitudeReference: AltitudeReference;
  holdSeconds: number | null;
}

/** A mission that is planned and not yet true. Immutable: every edit makes a new one, so undo is a list. */
export interface Draft {
  /** With a take-off height of its own; else the cloud lets it climb to the first waypoint's height. */
  takeOff: boolean;
  takeOffAltitude: number | null;
  waypoints: readonly DraftWaypoint[];
  ending: Ending;
  /** Where it lands, of a mission that ends by landing at a place; null: where it is then. */
  landing: DraftLanding | null;
  nextKey: number;
}

export interface AltitudeRange {
  lowest: number;
  highest: number;
}

/** The cloud takes the same ranges by program: a take-off goes up, a waypoint may lie below its take-off place. */
export const TAKE_OFF_RANGE: AltitudeRange = { lowest: 1, highest: 500 };
export const PLACE_RANGE: AltitudeRange = { lowest: -500, highest: 10_000 };
export const MOST_ITEMS = 500;

export function emptyDraft(): Draft {
  return { takeOff: false, takeOffAltitude: 20, waypoints: [], ending: 'hold', landing: null, nextKey: 1 };
}

/** Adds it at the end, or before the approach of a landing. */
export function addWaypoint(draft: Draft, place: Coordinates, altitude: number | null): Draft {
  const waypoint: DraftWaypoint = {
    key: draft.nextKey,
    latitude: place.latitude,
    longitude: place.longitude,
    altitude,
    altitudeReference: 'home',
    holdSeconds: null,
  };
  const last = draft.waypoints.at(-1);
  const led = last !== undefined && last.key === draft.landing?.approach;
  const at = led ? draft.waypoints.length - 1 : draft.waypoints.length;
  return { ...draft, waypoints: draft.waypoints.toSpliced(at, 0, waypoint), nextKey: draft.nextKey + 1 };
}

export function removeWaypoint(draft: Draft, key: number): Draft {
  return { ...draft, waypoints: draft.waypoints.filter((waypoint) => waypoint.key !== key) };
}

export function changeWaypoint(draft: Draft, key: number, change: Partial<DraftWaypoint>): Draft {
  return {
    ...draft,
    waypoints: draft.waypoints.map((waypoint) =>
      waypoint.key === key ? { ...waypoint, ...change, key } : waypoint,
    ),
  };
}

/** Moves a waypoint up (−1) or down (+1) the list; at the ends nothing changes. */
export function shiftWaypoint(draft: Draft, key: number, by: -1 | 1): Draft {
  const from = draft.waypoints.findIndex((waypoint) => waypoint.key === key);
  const to = from + by;
  const moved = draft.waypoints[from];
  const other = draft.waypoints[to];
  if (moved === undefined || other === undefined) {
    return draft;
  }
  const waypoints = [...draft.waypoints];
  waypoints[from] = other;
  waypoints[to] = moved;
  return { ...draft, waypoints };
}

/** In the order of these numbers, from 0; unchanged where they are not those of its waypoints. */
export function reordered(draft: Draft, order: readonly number[]): Draft {
  const waypoints = order.map((number) => draft.waypoints[number]).filter((one) => one !== undefined);
  const whole = new Set(waypoints).size === draft.waypoints.length && order.length === draft.waypoints.length;
  return whole ? { ...draft, waypoints } : draft;
}

/** Adds every place of a pasted text; says which lines were none. */
export function addPasted(
  draft: Draft,
  text: string,
  altitude: number | null,
): { draft: Draft; unreadable: string[] } {
  const { places, unreadable } = parseCoordinateLines(text);
  return { draft: places.reduce((so, place) => addWaypoint(so, place, altitude), draft), unreadable };
}

export function itemsOf(draft: Draft): PlannedItem[] {
  const items: PlannedItem[] = [];
  if (draft.takeOff) {
    items.push({ type: 'takeOff', altitude: draft.takeOffAltitude ?? Number.NaN });
  }
  items.push(...draft.waypoints.map(waypointItem));
  if (draft.ending === 'land') {
    items.push(landItem(draft.landing));
  } else if (draft.ending === 'returnToLaunch') {
    items.push({ type: 'returnToLaunch' });
  }
  return items;
}

/** Opens items in the editor; what the editor cannot express is counted, not silently lost. */
export function draftOf(items: readonly MissionItem[]): { draft: Draft; leftOut: number } {
  let draft = emptyDraft();
  let leftOut = 0;
  items.forEach((item, index) => {
    const last = index === items.length - 1;
    if (item.type === 'waypoint') {
      draft = addWaypoint(draft, item, item.altitude);
      draft = changeWaypoint(draft, draft.nextKey - 1, {
        altitudeReference: item.altitudeReference ?? 'home',
        holdSeconds: item.holdSeconds ?? null,
      });
    } else if (item.type === 'takeOff' && draft.waypoints.length === 0 && !draft.takeOff) {
      draft = { ...draft, takeOff: true, takeOffAltitude: item.altitude };
    } else if (item.type === 'returnToLaunch' && last) {
      draft = { ...draft, ending: 'returnToLaunch' };
    } else if (item.type === 'land' && last) {
      draft = { ...draft, ending: 'land', landing: landingOf(item) };
    } else {
      leftOut += 1;
    }
  });
  return { draft, leftOut };
}

/** The first reason why this plan cannot be uploaded, or null when it can. */
export function whyNotReady(draft: Draft, numberOf = ordinal): string | null {
  if (draft.waypoints.length === 0) {
    return 'Add a waypoint first: click the map.';
  }
  if (draft.takeOff && !isWithin(TAKE_OFF_RANGE, draft.takeOffAltitude)) {
    return altitudeRangeText('The altitude of the take-off', TAKE_OFF_RANGE);
  }
  const bad = draft.waypoints.findIndex((waypoint) => !isWithin(PLACE_RANGE, waypoint.altitude));
  if (bad >= 0) {
    return altitudeRangeText(`The altitude of item ${numberOf(bad)}`, PLACE_RANGE);
  }
  return whyNoLanding(draft) ?? tooLong(draft);
}

function whyNoLanding({ ending, landing }: Draft): string | null {
  if (ending !== 'land' || landing === null) {
    return null;
  }
  if (landing.place === null) {
    return 'Set the landing place: on the map, or by coordinates.';
  }
  return landing.altitude === null || isWithin(PLACE_RANGE, landing.altitude)
    ? null
    : altitudeRangeText('The ground of the landing place', PLACE_RANGE);
}

function tooLong(draft: Draft): string | null {
  return itemsOf(draft).length > MOST_ITEMS ? `A mission holds at most ${MOST_ITEMS} items.` : null;
}

export function isWithin(range: AltitudeRange, altitude: number | null): boolean {
  return altitude !== null && altitude >= range.lowest && altitude <= range.highest;
}

/** The sentence of the cloud itself: "… must be 1 to 500 m." */
export function altitudeRangeText(what: string, range: AltitudeRange): string {
  return `${what} must be ${range.lowest} to ${range.highest} m.`;
}

function ordinal(index: number): number {
  return index + 1;
}

export function lengthMeters(draft: Draft): number {
  const place = draft.ending === 'land' ? (draft.landing?.place ?? null) : null;
  return wayLengthMeters(place === null ? draft.waypoints : [...draft.waypoints, place]);
}

function waypointItem(waypoint: DraftWaypoint): WaypointItem {
  const item: WaypointItem = {
    type: 'waypoint',
    latitude: waypoint.latitude,
    longitude: waypoint.longitude,
    altitude: waypoint.altitude ?? Number.NaN,
    altitudeReference: waypoint.altitudeReference,
  };
  return waypoint.holdSeconds === null ? item : { ...item, holdSeconds: waypoint.holdSeconds };
}
