export type ConnectionState = 'connecting' | 'up' | 'down';

/** The state of the connection to the cloud. Ages are by the wall clock, which goes on in sleep. */
export class Connection {
  state = $state<ConnectionState>('connecting');
  /** By `performance.now`. */
  retryAt = $state<number | null>(null);
  #receivedAt: number | null = null;
  #downSince = $state<number | null>(null);
  #now = $state(Date.now());
  #retryNow = $state(performance.now());

  /** Another session: nothing of it was received yet. */
  begin(): void {
    this.state = 'connecting';
    this.#receivedAt = null;
    this.#downSince = null;
    this.retryAt = null;
  }

  /** A message was received: what is shown is no older than this. */
  received(): void {
    this.#receivedAt = Date.now();
  }

  up(): void {
    this.state = 'up';
    this.#downSince = null;
    this.retryAt = null;
  }

  down(): void {
    this.state = 'down';
    this.refresh();
    this.#downSince ??= this.#receivedAt ?? this.#now;
  }

  refresh(): void {
    this.#now = Date.now();
    this.#retryNow = performance.now();
  }

  /** The shown data may be old. */
  get stale(): boolean {
    return this.state !== 'up';
  }

  /** Seconds since the last message of the cloud. */
  get secondsDown(): number {
    return this.#downSince === null ? 0 : Math.max(0, Math.floor((this.#now - this.#downSince) / 1000));
  }

  get secondsToRetry(): number {
    return this.retryAt === null ? 0 : Math.max(0, Math.ceil((this.retryAt - this.#retryNow) / 1000));
  }
}
