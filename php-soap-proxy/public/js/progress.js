// @ts-check
/** What a drone does since a command that succeeded, told from its state. */
import { fixed, isAirborne, metersText, placeOf } from './drone.js';
import { distanceMeters } from './geo.js';
import { reachedText } from './mission.js';

/**
 * @typedef {import('./drone.js').Drone} Drone
 * @typedef {import('./commands.js').Entry} Entry
 * @typedef {{ state: 'goesOn' | 'done' | 'ended', words: string, figures: string }} Progress
 * `figures` change all the time, so nobody has them read out; `ended`: something else happened instead.
 */

/** They change what the drone does; the newest of them is what it is at. */
const FLIGHTS = new Set([
  'arm',
  'takeoff',
  'goto',
  'startMission',
  'pauseMission',
  'hold',
  'returnToLaunch',
  'land',
  'disarm',
]);
const NEAR_METERS = 2;
/** So old may the state be that the page has when it hears of the outcome. */
const STALE_MILLISECONDS = 2500;

/** Whether the drone may be at it. @param {Entry} entry */
export function isFlight({ operation, result }) {
  return FLIGHTS.has(operation) && (result === 'busy' || result === 'succeeded' || result === 'unknown');
}

/** Null: nothing is to be told beside the outcome. @param {Entry} entry @param {Drone} drone @returns {Progress | null} */
export function progressOf(entry, drone) {
  if (entry.operation === 'disarm') {
    return null;
  }
  const settled = entry.finished !== null && Date.now() - entry.finished > STALE_MILLISECONDS;
  if (settled && drone.armed === false && !isAirborne(drone)) {
    return atRest(entry, drone);
  }
  if (settled) {
    entry.mode ??= drone.mode;
  }
  const isLeft = settled && entry.mode !== drone.mode;
  const told = underWay(entry, drone);
  return told?.state === 'goesOn' && isLeft && entry.operation !== 'startMission'
    ? { state: 'ended', words: `its mode has changed to ${drone.mode}`, figures: '' }
    : told;
}

/** @param {Entry} entry @param {Drone} drone @returns {Progress} */
function atRest({ operation }, { mission }) {
  if (operation === 'arm') {
    return { state: 'ended', words: 'disarmed again', figures: '' };
  }
  const complete = operation === 'startMission' && mission.state === 'complete' ? 'complete, ' : '';
  return done(`${complete}landed and disarmed`);
}

/** @param {Entry} entry @param {Drone} drone @returns {Progress | null} */
function underWay({ operation, goal }, drone) {
  const height = drone.position?.altitudeAboveHome ?? null;
  switch (operation) {
    case 'takeoff':
      return climbing(height, goal?.altitude ?? 0, drone);
    case 'goto':
      return flyingTo(drone, goal, height);
    case 'startMission':
      return missionProgress(drone);
    case 'returnToLaunch':
      return drone.flight === 'landing'
        ? goesOn('at home, landing', `, ${fixed(height)} m above home`)
        : goesOn('on its way home', toGo(drone, drone.home));
    case 'land':
      return goesOn(isAirborne(drone) ? 'landing' : 'on the ground', `, ${fixed(height)} m above home`);
    default:
      return null;
  }
}

/** @param {number | null} height @param {number} goal @param {Drone} drone */
function climbing(height, goal, drone) {
  if (height !== null && height > goal - NEAR_METERS / 2) {
    return done('carried out');
  }
  return isAirborne(drone)
    ? goesOn('in the air', ` at ${fixed(height)} m of ${goal} m`)
    : goesOn('leaving the ground');
}

/** @param {Drone} drone @param {Entry['goal']} goal @param {number | null} height */
function flyingTo(drone, goal, height) {
  const place = placeOf(drone);
  const isThere =
    goal !== null &&
    place !== null &&
    distanceMeters(place, goal) < NEAR_METERS &&
    (height === null || Math.abs(height - goal.altitude) < NEAR_METERS);
  return isThere ? done('arrived') : goesOn('on its way', toGo(drone, goal));
}

/** @param {Drone} drone */
function missionProgress({ mission }) {
  if (mission.state === 'complete') {
    return done('complete');
  }
  const state = mission.state === 'paused' ? 'paused' : mission.running ? 'running' : 'not running';
  return goesOn(`${state}, ${reachedText(mission)}`);
}

/** @param {Drone} drone @param {import('./geo.js').Place | null} goal */
function toGo(drone, goal) {
  const place = placeOf(drone);
  return place === null || !goal ? '' : `, ${metersText(distanceMeters(place, goal))} to go`;
}

/** @param {string} words @param {string} [figures] @returns {Progress} */
function goesOn(words, figures = '') {
  return { state: 'goesOn', words, figures };
}

/** @param {string} words @returns {Progress} */
function done(words) {
  return { state: 'done', words, figures: '' };
}
