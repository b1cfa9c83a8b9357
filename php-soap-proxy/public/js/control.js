// @ts-check
/** Control of drones that this page has taken on purpose, and keeps by heartbeats. */
import { isBroken, sentenceOf } from './api.js';
import { isAirborne } from './drone.js';

/** @typedef {import('./drone.js').Drone} Drone */

const KEPT = 'dronemap-control';
const HEARTBEAT_MILLISECONDS = 2000;

export class Control {
  /** What went wrong last, by drone. @type {Map<string, string>} */
  problems = new Map();
  /** Drones in the air whose control was had here and has ended. @type {Drone[]} */
  lost = [];
  /** The epoch of each kept control, by drone. @type {Map<string, number>} */
  #kept = new Map(JSON.parse(sessionStorage.getItem(KEPT) ?? '[]'));
  /** Drones whose control is had here, or was until it ended in the air. */
  #had = new Set(this.#kept.keys());
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

  /** @param {readonly Drone[]} drones @param {string | null} user */
  watch(drones, user) {
    this.lost = drones.filter((drone) => {
      const has = this.isKept(drone.id) || isOf(drone, user);
      if (has) {
        this.#had.add(drone.id);
      } else if (!isAirborne(drone)) {
        this.#had.delete(drone.id);
      }
      return !has && this.#had.has(drone.id);
    });
  }

  /** @param {string} drone */
  async take(drone) {
    await this.#try(drone, () => this.ensure(drone));
  }

  /** Fails where it cannot be had. @param {string} drone */
  async ensure(drone) {
    if (!this.isKept(drone)) {
      const { epoch } = await this.#api.call('takeControl', { droneId: drone });
      this.#kept.set(drone, epoch);
      this.#changed();
    }
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
      try {
        const kept = await this.#api.call('keepControl', { droneId: drone, epoch });
        // After a restart of the server it is another one.
        if (this.#isStill(drone, epoch)) {
          this.#kept.set(drone, kept.epoch);
        }
      } catch (error) {
        if (isBroken(error)) {
          throw error;
        }
        // It has ended; who has it now is told with the drone.
        if (this.#isStill(drone, epoch)) {
          this.#kept.delete(drone);
        }
      }
    });
  }

  /** An answer may come after control has been taken anew. @param {string} drone @param {number} epoch */
  #isStill(drone, epoch) {
    return this.#kept.get(drone) === epoch;
  }

  /** @param {string} drone @param {() => Promise<unknown>} call */
  async #try(drone, call) {
    try {
      await call();
      this.problems.delete(drone);
    } catch (error) {
      this.problems.set(drone, sentenceOf(error));
    }
    this.#changed();
  }

  #changed() {
    sessionStorage.setItem(KEPT, JSON.stringify([...this.#kept]));
    this.#onChange();
  }
}

/** @param {Drone} drone @param {string | null} user */
function isOf({ control }, user) {
  return control.state === 'held' && control.holder === user;
}

/**
 * Who commands the drone, in a sentence.
 * @param {Drone} drone @param {string | null} user @param {boolean} kept by this page
 */
export function controlText(drone, user, kept) {
  const { control } = drone;
  if (kept) {
    const then = drone.mission.running ? 'finishes its mission' : 'holds';
    return `You have control while this page is open and in sight. When you close it, the drone ${then}, then flies home.`;
  }
  if (control.state === 'pilot') {
    return 'The pilot at the vehicle, or another ground station, commands it.';
  }
  if (control.state === 'free') {
    return 'Nobody has control; your first command takes it.';
  }
  if (!isOf(drone, user)) {
    return `${control.holder} has control.`;
  }
  return control.explicit
    ? 'You have control, taken elsewhere.'
    : 'You have control until 30 s after your last command; in the air it is brought home then. Take control to keep it.';
}

/** What is said of a drone in the air whose control has ended here. @param {Drone} drone */
export function lostText({ name, control, outlook }) {
  const who = control.state === 'held' ? `: ${control.holder} has control` : '';
  return `Your control of ${name} has ended${who}. ${outlook?.then ?? ''}`.trim();
}
