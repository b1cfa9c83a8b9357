import { sentenceFor } from '../api/problem';

/** A list that the server keeps, read anew after each change, and the sentence of what went wrong last. */
export class ServerList<T> {
  items = $state.raw<readonly T[]>([]);
  problem = $state<string | null>(null);
  /** It was read: somebody shows it. */
  loaded = false;
  readonly #read: () => Promise<readonly T[]>;
  readonly #onChange: () => void;
  /** The sentence is about reading, and goes when that succeeds again. */
  #unread = false;

  /** `onChange` is called after each change that was made here. */
  constructor(read: () => Promise<readonly T[]>, onChange: () => void = () => undefined) {
    this.#read = read;
    this.#onChange = onChange;
  }

  clear(): void {
    this.items = [];
    this.problem = null;
    this.loaded = false;
  }

  /** False when the change, or reading the list after it, failed. */
  async change(action: () => Promise<unknown>): Promise<boolean> {
    try {
      await action();
      this.#onChange();
      this.items = await this.#read();
      this.loaded = true;
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
      this.loaded = true;
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
