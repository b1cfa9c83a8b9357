// @ts-check
/** What a drone's state, as SOAP tells it, means in words. */

/**
 * @typedef {import('./geo.js').Place} Place
 * @typedef {{ allowed: boolean, why?: string | null, mode?: string | null }} Action
 * @typedef {{ state: 'free' | 'held' | 'pilot', holder: string | null, explicit: boolean, since: string | null,
 *   epoch: number }} Control
 * @typedef {{ items: any[] | null, current: number | null, reached: number[] | null, total: number | null,
 *   running: boolean, state: string | null, notice: string | null }} VehicleMission
 * @typedef {{
 *   id: string, name: string, kind: string, vehicle: string, mode: string | null, armed: boolean | null,
 *   flight: 'onGround' | 'takingOff' | 'inAir' | 'landing' | null,
 *   link: { address: string, port: number, systemId: number, transport: string,
 *     state: 'live' | 'suspect' | 'lost' | 'ended', lastHeard: string | null },
 *   position: (Place & { altitudeAmsl: number | null, altitudeAboveHome: number | null }) | null,
 *   motion: { groundSpeed: number | null, climbRate: number | null, heading: number | null } | null,
 *   battery: { percent: number | null, volts: number | null } | null,
 *   gps: { fix: string, satellites: number | null } | null,
 *   home: (Place & { altitudeAmsl: number }) | null,
 *   mission: VehicleMission, control: Control, actions: Record<string, Action>,
 *   outlook: { state: string, then: string, returnsAt: string | null } | null, lastUpdate: string,
 * }} Drone
 * @typedef {'neutral' | 'good' | 'look' | 'act'} Tone
 */

/** The text for what is not known. */
export const UNKNOWN = '—';

/** @param {number | null | undefined} value @param {number} [digits] */
export function fixed(value, digits = 0) {
  if (value === null || value === undefined) {
    return UNKNOWN;
  }
  const text = value.toFixed(digits);
  // Minus zero would flicker between "0.0" and "-0.0".
  return Number(text) === 0 ? (0).toFixed(digits) : text.replace('-', '−');
}

/** @param {number} milliseconds */
export function spanText(milliseconds) {
  const seconds = Math.max(0, Math.floor(milliseconds / 1000));
  if (seconds < 60) {
    return `${seconds} s`;
  }
  if (seconds < 3600) {
    return `${Math.floor(seconds / 60)} min ${String(seconds % 60).padStart(2, '0')} s`;
  }
  return seconds < 86_400 ? `${Math.floor(seconds / 3600)} h` : `${Math.floor(seconds / 86_400)} d`;
}

/** The time since anything was heard of it. @param {Drone} drone @param {number} now the server's time */
export function updateText({ link, lastUpdate }, now) {
  const age = now - Date.parse(link.lastHeard ?? lastUpdate);
  return age < 2000 ? 'now' : `${spanText(age)} ago`;
}

/** @param {number} meters */
export function metersText(meters) {
  return meters < 1000 ? `${Math.round(meters)} m` : `${Number((meters / 1000).toFixed(2))} km`;
}

/** @param {Drone} drone @returns {Place | null} */
export function placeOf({ position }) {
  return position && position.latitude !== null && position.longitude !== null ? position : null;
}

/** The state of a drone in words, and how urgent it is. @param {Drone} drone */
export function statusOf(drone) {
  const { link, armed } = drone;
  switch (link.state) {
    case 'ended':
      return status('Replay ended', 'neutral');
    case 'lost':
      // One that was armed may still be flying: that needs somebody.
      return status('Lost: not heard', armed ? 'act' : 'neutral');
    case 'suspect':
      return status('Silent', 'look');
    default:
      return flightStatus(drone);
  }
}

/** @param {Drone} drone */
function flightStatus({ flight, armed }) {
  const words = { takingOff: 'Taking off', inAir: 'Flying', landing: 'Landing', onGround: '' }[
    flight ?? 'onGround'
  ];
  if (words !== '') {
    return status(words, 'good');
  }
  if (armed === null) {
    return status('State unknown', 'neutral');
  }
  return armed ? status('Armed, on the ground', 'look') : status('On the ground', 'neutral');
}

/** @param {string} words @param {Tone} tone */
function status(words, tone) {
  return { words, tone };
}

/** @param {Drone} drone */
export function isAirborne({ flight }) {
  return flight === 'takingOff' || flight === 'inAir' || flight === 'landing';
}

/** @param {Drone} drone */
export function armedText({ armed }) {
  return armed === null ? 'Unknown' : armed ? 'Armed' : 'Disarmed';
}

/** @param {Drone} drone */
export function batteryText({ battery }) {
  const { percent = null, volts = null } = battery ?? {};
  const parts = [percent === null ? null : `${percent} %`, volts === null ? null : `${fixed(volts, 1)} V`];
  return parts.filter((part) => part !== null).join(' · ') || UNKNOWN;
}

/** "127.0.0.1:52273 · system 21" @param {Drone} drone */
export function linkText({ link }) {
  return `${link.address}:${link.port} · system ${link.systemId}`;
}

/** Why the server would refuse this now; null: it would not. @param {Drone} drone @param {string} action */
export function whyNot(drone, action) {
  const found = drone.actions[action];
  if (found === undefined) {
    return 'This vehicle cannot do that.';
  }
  return found.allowed ? null : (found.why ?? 'Not possible now.');
}
