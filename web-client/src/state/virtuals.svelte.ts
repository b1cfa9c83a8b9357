import { sentenceFor } from '../api/problem';
import type { PlannedItem } from '../api/types';
import type { DroneName, VirtualCalls, VirtualDrone, VirtualNeeds } from '../api/virtual';

/** The virtual drones of the user, and the pool of drones that may serve them. */
export class Virtuals {
  all = $state.raw<readonly VirtualDrone[]>([]);
  pool = $state.raw<readonly DroneName[]>([]);
  problem = $state<string | null>(null);
  readonly #calls: VirtualCalls;

  constructor(calls: VirtualCalls) {
    this.#calls = calls;
  }

  find(id: string | null): VirtualDrone | null {
    return this.all.find((drone) => drone.id === id) ?? null;
  }

  /** Replaces all: some may have been removed while the connection was down. */
  async load(): Promise<void> {
    await this.#attempt(async () => {
      const [all, pool] = await Promise.all([this.#calls.all(), this.#calls.pool()]);
      this.all = all;
      this.pool = pool;
    });
  }

  apply(drone: VirtualDrone): void {
    this.all = this.all.some((one) => one.id === drone.id)
      ? this.all.map((one) => (one.id === drone.id ? drone : one))
      : [...this.all, drone];
  }

  applyRemoval(id: string): void {
    this.all = this.all.filter((drone) => drone.id !== id);
  }

  clear(): void {
    this.all = [];
    this.pool = [];
    this.problem = null;
  }

  /** Answers whether it worked. */
  add(name: string, needs: VirtualNeeds): Promise<boolean> {
    return this.#attempt(async () =>
      this.apply(await this.#calls.add({ name, needs, items: null, upTo: 1 })),
    );
  }

  plan(drone: VirtualDrone, items: readonly PlannedItem[], upTo: number): Promise<boolean> {
    const request = { name: drone.name, needs: drone.needs, items: [...items], upTo };
    return this.#attempt(async () => this.apply(await this.#calls.replace(drone.id, request)));
  }

  act(id: string, action: 'start' | 'stop' | 'resume'): Promise<boolean> {
    return this.#attempt(async () => this.apply(await this.#calls.act(id, action)));
  }

  remove(id: string): Promise<boolean> {
    return this.#attempt(async () => {
      await this.#calls.remove(id);
      this.applyRemoval(id);
    });
  }

  offer(drone: string): Promise<boolean> {
    return this.#attempt(async () => {
      this.pool = await this.#calls.offer(drone);
    });
  }

  withdraw(drone: string): Promise<boolean> {
    return this.#attempt(async () => {
      await this.#calls.withdraw(drone);
      this.pool = this.pool.filter((one) => one.id !== drone);
    });
  }

  async #attempt(action: () => Promise<void>): Promise<boolean> {
    try {
      await action();
      this.problem = null;
      return true;
    } catch (thrown) {
      this.problem = sentenceFor(thrown);
      return false;
    }
  }
}
