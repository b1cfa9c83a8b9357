import { Problem, sentenceFor } from '../api/problem';
import type { Recovery, RecoveryCalls, RecoveryOrder, RecoveryPreview } from '../api/recoveries';

/** Drones that come home, or land, together, and what is shown before that is confirmed. */
export class Recoveries {
  /** What would be done, until somebody confirms it or leaves it. */
  preview = $state.raw<RecoveryPreview | null>(null);
  problem = $state<string | null>(null);
  /** Something was sent and is not answered yet. */
  busy = $state(false);
  #order = $state.raw<RecoveryOrder | null>(null);
  #all = $state.raw<ReadonlyMap<string, Recovery>>(new Map());
  readonly #calls: RecoveryCalls;

  constructor(calls: RecoveryCalls) {
    this.#calls = calls;
  }

  /** Those of a user that are under way, and those that ended and were not put aside, the newest first. */
  shown(owner: string | undefined): Recovery[] {
    return [...this.#all.values()]
      .filter((one) => one.owner === owner)
      .sort((a, b) => b.beganAt.localeCompare(a.beganAt));
  }

  apply(recovery: Recovery): void {
    // Of one that was over before nothing is told.
    if (this.#all.has(recovery.id) || recovery.state !== 'over') {
      this.#all = new Map(this.#all).set(recovery.id, recovery);
    }
  }

  putAside(id: string): void {
    const all = new Map(this.#all);
    all.delete(id);
    this.#all = all;
  }

  leave(): void {
    this.preview = null;
    this.#order = null;
    this.problem = null;
  }

  clear(): void {
    this.leave();
    this.#all = new Map();
  }

  /** After the connection was lost. */
  async catchUp(): Promise<void> {
    if (this.#all.size > 0) {
      await this.#attempt(async () => (await this.#calls.all()).forEach((one) => this.apply(one)));
    }
  }

  async look(manner: RecoveryOrder['manner']): Promise<void> {
    this.leave();
    const order = { manner };
    await this.#attempt(async () => {
      this.preview = await this.#calls.preview(order);
      this.#order = order;
    });
  }

  /** Only what is shown: where others would come by now, that is shown first. */
  async confirm(): Promise<void> {
    const { preview } = this;
    const order = this.#order;
    if (order === null || preview === null) {
      return;
    }
    const previewed = preview.drones.map((one) => one.drone);
    await this.#attempt(async () => {
      try {
        this.apply(await this.#calls.begin({ ...order, previewed }));
        this.leave();
      } catch (thrown) {
        if (thrown instanceof Problem && thrown.code === 'recovery-changed') {
          this.preview = null;
          this.preview = await this.#calls.preview(order);
        }
        throw thrown;
      }
    });
  }

  async cancel(id: string): Promise<void> {
    await this.#attempt(async () => this.apply(await this.#calls.cancel(id)));
  }

  async #attempt(action: () => Promise<void>): Promise<void> {
    this.busy = true;
    try {
      await action();
      this.problem = null;
    } catch (thrown) {
      this.problem = sentenceFor(thrown);
    } finally {
      this.busy = false;
    }
  }
}
