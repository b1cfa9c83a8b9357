// @ts-check
/** The mission that a person plans for a drone, and how it differs from the one on board. */

/**
 * @typedef {{ key: number, latitude: number, longitude: number, altitude: number,
 *   altitudeReference: 'home' | 'amsl', holdSeconds: number }} Waypoint
 * @typedef {'hold' | 'returnToLaunch' | 'land'} Ending
 * @typedef {import('./drone.js').VehicleMission} Mission
 * @typedef {{ takeOff: number | null, waypoints: Waypoint[], ending: Ending, leftOut: number }} Draft
 * Altitudes in metres; `takeOff` null: the server adds one to the first waypoint's height; `leftOut`: items of the
 * drone's mission that this page cannot show.
 */

const DRAFTS = 'dronemap-drafts';
export const MOST_WAYPOINTS = 498;

/** @returns {Draft} */
export function emptyDraft() {
  return { takeOff: null, waypoints: [], ending: 'hold', leftOut: 0 };
}

/** @param {Draft} draft @param {import('./geo.js').Place} place @param {number} altitude @returns {Draft} */
export function withWaypoint(draft, { latitude, longitude }, altitude) {
  const key = Math.max(0, ...draft.waypoints.map((waypoint) => waypoint.key)) + 1;
  /** @type {Waypoint} */
  const waypoint = { key, latitude, longitude, altitude, altitudeReference: 'home', holdSeconds: 0 };
  return { ...draft, waypoints: [...draft.waypoints, waypoint] };
}

/** @param {Draft} draft @param {number} key @param {Partial<Waypoint>} change @returns {Draft} */
export function withChange(draft, key, change) {
  const waypoints = draft.waypoints.map((one) => (one.key === key ? { ...one, ...change } : one));
  return { ...draft, waypoints };
}

/** @param {Draft} draft @param {number} key @returns {Draft} */
export function without(draft, key) {
  return { ...draft, waypoints: draft.waypoints.filter((one) => one.key !== key) };
}

/**
 * One place earlier (−1) or later (+1).
 * @param {Draft} draft @param {number} key @param {-1 | 1} by
 * @returns {Draft}
 */
export function shifted(draft, key, by) {
  const from = draft.waypoints.findIndex((one) => one.key === key);
  const waypoints = [...draft.waypoints];
  const [moved] = waypoints.splice(from, 1);
  if (moved !== undefined) {
    waypoints.splice(Math.max(0, from + by), 0, moved);
  }
  return { ...draft, waypoints };
}

/** The items as SOAP has them: each an object with one member. @param {Draft} draft @returns {object[]} */
export function itemsOf(draft) {
  const items = draft.waypoints.map(({ key, ...waypoint }) => ({ waypoint }));
  const takeOff = draft.takeOff === null ? [] : [{ takeOff: { altitude: draft.takeOff } }];
  return [...takeOff, ...items, ...(draft.ending === 'hold' ? [] : [{ [draft.ending]: {} }])];
}

/** What this page cannot express is counted. @param {readonly any[]} items @returns {Draft} */
export function draftOf(items) {
  let draft = emptyDraft();
  items.forEach((item, index) => {
    if (item.waypoint) {
      const { latitude, longitude, altitude, altitudeReference, holdSeconds } = item.waypoint;
      const place = { altitudeReference: altitudeReference ?? 'home', holdSeconds: holdSeconds ?? 0 };
      draft = withWaypoint(draft, { latitude, longitude }, altitude);
      draft = withChange(draft, draft.waypoints.length, place);
    } else if (item.takeOff && index === 0) {
      draft = { ...draft, takeOff: item.takeOff.altitude };
    } else if (index === items.length - 1 && ('returnToLaunch' in item || 'land' in item)) {
      draft = { ...draft, ending: 'land' in item ? 'land' : 'returnToLaunch' };
    } else {
      draft = { ...draft, leftOut: draft.leftOut + 1 };
    }
  });
  return draft;
}

/** Vehicles keep places as whole numbers of 1e-7 degrees. */
const PLACE_DEGREES = 2e-7;
const HEIGHT_METERS = 0.05;

/** Whether the drone would fly the draft if it flew its mission. @param {Draft} draft @param {readonly any[]} items */
export function isOnBoard(draft, items) {
  const there = draftOf(items);
  return (
    there.leftOut === 0 &&
    draft.leftOut === 0 &&
    there.ending === draft.ending &&
    (draft.takeOff === null || Math.abs(draft.takeOff - (there.takeOff ?? -1)) < HEIGHT_METERS) &&
    there.waypoints.length === draft.waypoints.length &&
    there.waypoints.every((one, index) => isSame(one, draft.waypoints[index]))
  );
}

/** @param {Waypoint} one @param {Waypoint | undefined} other */
function isSame(one, other) {
  return (
    other !== undefined &&
    Math.abs(one.latitude - other.latitude) < PLACE_DEGREES &&
    Math.abs(one.longitude - other.longitude) < PLACE_DEGREES &&
    Math.abs(one.altitude - other.altitude) < HEIGHT_METERS &&
    one.altitudeReference === other.altitudeReference &&
    one.holdSeconds === other.holdSeconds
  );
}

/** "2 of 3 waypoints reached": items of other kinds are no places to count. @param {Mission} mission */
export function reachedText({ items, total, reached }) {
  const waypoints = (items ?? []).flatMap((item, index) => (item.waypoint ? [index] : []));
  const done = new Set(reached ?? []);
  return items === null || waypoints.length === 0
    ? `${done.size} of ${total ?? '?'} items reached`
    : `${waypoints.filter((index) => done.has(index)).length} of ${waypointsText(waypoints.length)} reached`;
}

/** What the vehicle says of it goes before what its mode tells. @param {Mission | undefined} mission */
export function isRunning(mission) {
  return mission !== undefined && (mission.state === null ? mission.running : mission.state === 'running');
}

/** @param {number} count */
export function waypointsText(count) {
  return `${count} ${count === 1 ? 'waypoint' : 'waypoints'}`;
}

/** The mission on board in a sentence. @param {Mission} mission */
export function onBoardText(mission) {
  const { items, total, running, state, reached } = mission;
  const count = items?.length ?? total;
  if (count === null) {
    return 'The mission on the drone is not known.';
  }
  if (count === 0) {
    return 'There is no mission on the drone.';
  }
  const done = new Set(reached ?? []).size;
  const far = reachedText(mission);
  if (state === 'complete') {
    return `On the drone: mission complete, ${far}.`;
  }
  if (running) {
    return `On the drone: mission is running, ${far}.`;
  }
  if (state === 'paused' || done > 0) {
    return `On the drone: mission is ${state === 'paused' ? 'paused' : 'not running'}, ${far}.`;
  }
  const waypoints = (items ?? []).filter((item) => item.waypoint).length;
  const size = waypoints > 0 ? waypointsText(waypoints) : `${count} items`;
  return `On the drone: mission of ${size}, not running.`;
}

/** The drafts of this tab, one for each drone; they outlive a reload and the end of a session. */
export class Drafts {
  /** @type {Record<string, Draft>} */
  #drafts = JSON.parse(sessionStorage.getItem(DRAFTS) ?? '{}');

  /** @param {string | null} drone @returns {Draft} */
  of(drone) {
    return (drone === null ? undefined : this.#drafts[drone]) ?? emptyDraft();
  }

  /** @param {string} drone @param {Draft} draft */
  put(drone, draft) {
    this.#drafts[drone] = draft;
    sessionStorage.setItem(DRAFTS, JSON.stringify(this.#drafts));
  }
}
