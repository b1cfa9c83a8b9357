// @ts-check
/** Control of drones that this page has taken on purpose, and keeps by heartbeats. */
import { isBroken, sentenceOf } from './api.js';

/** @typedef {import('./drone.js').Drone} Drone */

const KEPT = 'dronemap-control';
const HEARTBEAT_MILLISECONDS = 2000;

export class Control {
  /** What went wrong last, by drone. @type {Map<string, string>} */
  problems = new Map();
  /** The epoch of each kept control, by drone. @type {Map<string, number>} */
  #kept = new Map(JSON.parse(sessionStorage.getItem(KEPT) ?? '[]'));
  #api;
  #onChange;

  /** @param {import('./api.js').Api} api @param {() => void} onChange */
  constructor(api, onChange) {
    this.#api = api;
    this.#onChange = onChange;
    setInterval(() => void this.#keep(), HEARTBEAT_MILLISECONDS);
  }

  /** @param {string} drone */
  isKept(drone) {
    return this.#kept.has(drone);
  }

  /** @param {string} drone */
  async take(drone) {
    await this.#try(drone, async () => {
      const { epoch } = await this.#api.call('takeControl', { droneId: drone });
      this.#kept.set(drone, epoch);
    });
  }

  /** @param {string} drone */
  async giveBack(drone) {
    this.#kept.delete(drone);
    await this.#try(drone, () => this.#api.call('releaseControl', { droneId: drone }));
  }

  async giveAllBack() {
    await Promise.all(Array.from(this.#kept.keys(), (drone) => this.giveBack(drone)));
  }

  async #keep() {
    if (!this.#api.hasToken) {
      return;
    }
    await Promise.all(Array.from(this.#kept, ([drone, epoch]) => this.#keepOne(drone, epoch)));
  }

  /** @param {string} drone @param {number} epoch */
  async #keepOne(drone, epoch) {
    await this.#try(drone, async () => {
      const kept = await this.#api.call('keepControl', { droneId: drone, epoch });
      // After a restart of the server it is another one.
      if (this.#kept.has(drone)) {
        this.#kept.set(drone, kept.epoch);
      }
    });
  }

  /** @param {string} drone @param {() => Promise<unknown>} call */
  async #try(drone, call) {
    try {
      await call();
      this.problems.delete(drone);
    } catch (error) {
      this.problems.set(drone, sentenceOf(error));
      if (!isBroken(error)) {
        this.#kept.delete(drone);
      }
    }
    sessionStorage.setItem(KEPT, JSON.stringify([...this.#kept]));
    this.#onChange();
  }
}

/**
 * Who commands the drone, in a sentence.
 * @param {Drone} drone @param {string | null} user @param {boolean} kept by this page
 */
export function controlText({ control }, user, kept) {
  if (control.state === 'pilot') {
    return 'The pilot at the vehicle, or another ground station, commands it.';
  }
  if (control.state === 'free') {
    return 'Nobody has control; your first command takes it.';
  }
  if (kept) {
    return 'You have control while this page is open and in sight.';
  }
  if (control.holder !== user) {
    return `${control.holder} has control.`;
  }
  return control.explicit
    ? 'You have control, taken elsewhere.'
    : 'You have control until 30 s after your last command; take it to keep it.';
}
