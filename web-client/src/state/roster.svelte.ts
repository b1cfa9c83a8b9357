import { sentenceFor } from '../api/problem';

/** A list that the server keeps, read anew after each change, and the sentence of what went wrong last. */
export class Roster<T> {
  items = $state.raw<readonly T[]>([]);
  problem = $state<string | null>(null);
  readonly #read: () => Promise<readonly T[]>;
  /** The sentence is about reading, and goes when that succeeds again. */
  #unread = false;

  constructor(read: () => Promise<readonly T[]>) {
    this.#read = read;
  }

  /** False when the change, or reading the list after it, failed. */
  async change(action: () => Promise<unknown>): Promise<boolean> {
    try {
      await action();
      this.items = await this.#read();
      this.problem = null;
      return true;
    } catch (thrown) {
      this.problem = sentenceFor(thrown);
      this.#unread = false;
      return false;
    }
  }

  /** Leaves the sentence about a change that failed in its place. */
  async refresh(): Promise<void> {
    try {
      this.items = await this.#read();
      if (this.#unread) {
        this.problem = null;
      }
      this.#unread = false;
    } catch (thrown) {
      this.problem = sentenceFor(thrown);
      this.#unread = true;
    }
  }
}
