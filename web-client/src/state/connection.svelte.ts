export type ConnectionState = 'connecting' | 'up' | 'down';

/** Whether what the page shows is true now. Times are of `performance.now`. */
export class Connection {
  state = $state<ConnectionState>('connecting');
  retryAt = $state<number | null>(null);
  #downSince = $state<number | null>(null);
  #now = $state(performance.now());

  up(): void {
    this.state = 'up';
    this.#downSince = null;
    this.retryAt = null;
  }

  down(): void {
    this.state = 'down';
    this.#now = performance.now();
    this.#downSince ??= this.#now;
  }

  tick(): void {
    this.#now = performance.now();
  }

  get secondsDown(): number {
    return this.#downSince === null ? 0 : Math.max(0, Math.floor((this.#now - this.#downSince) / 1000));
  }

  get secondsToRetry(): number {
    return this.retryAt === null ? 0 : Math.max(0, Math.ceil((this.retryAt - this.#now) / 1000));
  }
}
