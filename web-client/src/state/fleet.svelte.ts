import type { Drone } from '../api/types';
import { LinkHistory } from './link-history';
import { Trails } from './trails';

/** Runs an action soon, at most one at a time; the page redraws ten times a second however fast updates come. */
export type Scheduler = (action: () => void) => void;

export const tenTimesASecond: Scheduler = (action) => {
  setTimeout(action, 100);
};

/** Every drone that the cloud shows us, newest version of each. */
export class Fleet {
  /** By name; a new array for every redraw. */
  drones = $state.raw<readonly Drone[]>([]);
  /** False until the first whole list has come. */
  loaded = $state(false);
  readonly trails = new Trails();
  readonly links = new LinkHistory();
  readonly #byId = new Map<string, Drone>();
  readonly #schedule: Scheduler;
  #pending = false;

  constructor(schedule: Scheduler = tenTimesASecond) {
    this.#schedule = schedule;
  }

  /** The whole list: drones that are not in it are gone. */
  replaceAll(drones: readonly Drone[]): void {
    const present = new Set(drones.map((drone) => drone.id));
    for (const id of this.#byId.keys()) {
      if (!present.has(id)) {
        this.#delete(id);
      }
    }
    for (const drone of drones) {
      this.#store(drone);
    }
    this.loaded = true;
    this.#publish();
  }

  /** Applies an update of one drone; an older version than the known one changes nothing. */
  update(drone: Drone): void {
    const known = this.#byId.get(drone.id);
    if (known !== undefined && drone.version < known.version) {
      return;
    }
    this.#store(drone);
    this.#publishSoon();
  }

  remove(id: string): void {
    this.#delete(id);
    this.#publish();
  }

  clear(): void {
    this.replaceAll([]);
    this.loaded = false;
  }

  find(id: string | null): Drone | null {
    return id === null ? null : (this.drones.find((drone) => drone.id === id) ?? null);
  }

  #store(drone: Drone): void {
    this.#byId.set(drone.id, drone);
    this.trails.add(drone);
    this.links.add(drone);
  }

  #delete(id: string): void {
    this.#byId.delete(id);
    this.trails.remove(id);
    this.links.remove(id);
  }

  #publishSoon(): void {
    if (!this.#pending) {
      this.#pending = true;
      this.#schedule(() => this.#publish());
    }
  }

  #publish(): void {
    this.#pending = false;
    this.drones = [...this.#byId.values()].sort(
      (a, b) => a.name.localeCompare(b.name, undefined, { numeric: true }) || a.id.localeCompare(b.id),
    );
  }
}
