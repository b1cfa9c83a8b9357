import type { Fix } from './fix';

/** As many as the cloud accepts at once. */
export const MOST_FIXES = 60;
/**
 * Fixes that wait to be sent. Policy: the newest 60, about a minute; when there is no room the oldest goes, counted. One
 * is removed when the cloud has acknowledged it, so that what was lost is sent again.
 */
export class FixBuffer {
  /** The number dropped for lack of room. */
  dropped = 0;
  #waiting: readonly Fix[] = [];

  /** Oldest first. */
  get pending(): readonly Fix[] {
    return this.#waiting;
  }

  add(fix: Fix): void {
    const newest = this.#waiting.at(-1);
    if (newest !== undefined && fix.at <= newest.at) {
      return;
    }
    const all = [...this.#waiting, fix];
    this.#waiting = all.slice(-MOST_FIXES);
    this.dropped += all.length - this.#waiting.length;
  }

  /** The cloud has dealt with all up to this time. */
  acknowledge(upTo: number): void {
    this.#waiting = this.#waiting.filter((fix) => fix.at > upTo);
  }

  clear(): void {
    this.#waiting = [];
  }
}
