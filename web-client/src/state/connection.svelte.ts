export type ConnectionState = 'connecting' | 'up' | 'down';

/** Whether what the page shows is true now, and since when it is not. Ages are of the wall clock, which goes on in sleep. */
export class Connection {
  state = $state<ConnectionState>('connecting');
  /** By `performance.now`. */
  retryAt = $state<number | null>(null);
  #heardAt: number | null = null;
  #downSince = $state<number | null>(null);
  #now = $state(Date.now());
  #retryNow = $state(performance.now());

  /** Another session: nothing of it was heard yet. */
  begin(): void {
    this.state = 'connecting';
    this.#heardAt = null;
    this.#downSince = null;
    this.retryAt = null;
  }

  /** Something came: what is shown is as old as this at most. */
  heard(): void {
    this.#heardAt = Date.now();
  }

  up(): void {
    this.state = 'up';
    this.#downSince = null;
    this.retryAt = null;
  }

  down(): void {
    this.state = 'down';
    this.tick();
    this.#downSince ??= this.#heardAt ?? this.#now;
  }

  tick(): void {
    this.#now = Date.now();
    this.#retryNow = performance.now();
  }

  /** What is shown may be old. */
  get stale(): boolean {
    return this.state !== 'up';
  }

  /** Since the cloud was heard last. */
  get secondsDown(): number {
    return this.#downSince === null ? 0 : Math.max(0, Math.floor((this.#now - this.#downSince) / 1000));
  }

  get secondsToRetry(): number {
    return this.retryAt === null ? 0 : Math.max(0, Math.ceil((this.retryAt - this.#retryNow) / 1000));
  }
}
