import type { Dispatch, DispatchCalls, DispatchNow } from '../api/dispatches';
import { sentenceFor } from '../api/problem';
import type { Coordinates } from '../geo/coordinates';

/** Drones that were sent to a place, and the place that is being asked for. */
export class Dispatches {
  /** The next press on the map marks the place. */
  picking = $state(false);
  /** The place where a drone is wanted, until somebody confirms it. */
  place = $state.raw<Coordinates | null>(null);
  problem = $state<string | null>(null);
  /** Something was sent and is not answered yet. */
  busy = $state(false);
  #all = $state.raw<ReadonlyMap<string, Dispatch>>(new Map());
  /** Asked for in this window, whose drones it takes in hand; each until that was done. */
  readonly #expected = new Set<string>();
  readonly #calls: DispatchCalls;

  constructor(calls: DispatchCalls) {
    this.#calls = calls;
  }

  /** Those of a user that are under way, the newest first. */
  underWay(owner: string | undefined): Dispatch[] {
    return [...this.#all.values()]
      .filter((one) => one.owner === owner && one.state !== 'over')
      .sort((a, b) => b.beganAt.localeCompare(a.beganAt));
  }

  /** One that ended without a drone, and whose reason nobody has put aside yet. */
  ended(owner: string | undefined): Dispatch[] {
    return [...this.#all.values()].filter((one) => one.owner === owner && one.state === 'over');
  }

  apply(dispatch: Dispatch): void {
    const known = this.#all.get(dispatch.id);
    // Of one that was over before nothing is told.
    if (known === undefined && dispatch.state === 'over') {
      return;
    }
    if (known === undefined || known.told.length <= dispatch.told.length || known.since <= dispatch.since) {
      this.#all = new Map(this.#all).set(dispatch.id, dispatch);
    }
  }

  applyNow(id: string, now: DispatchNow | null): void {
    const known = this.#all.get(id);
    if (known !== undefined) {
      this.#all = new Map(this.#all).set(id, { ...known, now });
    }
  }

  putAside(id: string): void {
    const all = new Map(this.#all);
    all.delete(id);
    this.#all = all;
  }

  /** The drone that has come for this window and was not taken in hand yet, or null; it is answered once. */
  takeArrival(): string | null {
    for (const id of this.#expected) {
      const dispatch = this.#all.get(id);
      if (dispatch?.state === 'here' && dispatch.drone !== null) {
        this.#expected.delete(id);
        return dispatch.drone;
      }
    }
    return null;
  }

  setPlace({ latitude, longitude }: Coordinates): void {
    this.place = { latitude, longitude };
    this.picking = false;
    this.problem = null;
  }

  leave(): void {
    this.place = null;
    this.picking = false;
    this.problem = null;
  }

  clear(): void {
    this.leave();
    this.#all = new Map();
    this.#expected.clear();
  }

  /** After the connection was lost. */
  async catchUp(): Promise<void> {
    if (this.#all.size > 0) {
      await this.#attempt(async () => (await this.#calls.all()).forEach((one) => this.apply(one)));
    }
  }

  /** Answers whether a drone comes. */
  async send(height: number): Promise<boolean> {
    const { place } = this;
    return (
      place !== null &&
      this.#attempt(async () => {
        const dispatch = await this.#calls.send({ ...place, height });
        this.#expected.add(dispatch.id);
        this.apply(dispatch);
        this.leave();
      })
    );
  }

  async cancel(id: string): Promise<void> {
    await this.#attempt(async () => this.apply(await this.#calls.cancel(id)));
  }

  async #attempt(action: () => Promise<void>): Promise<boolean> {
    this.busy = true;
    try {
      await action();
      this.problem = null;
      return true;
    } catch (thrown) {
      this.problem = sentenceFor(thrown);
      return false;
    } finally {
      this.busy = false;
    }
  }
}
