/** What waits for a reader who may be slow: of what has the same key the newest alone, and no more than so much. */
export class NewestQueue<T> {
  readonly #waiting = new Map<unknown, T>();
  readonly #most: number;
  #lost = 0;
  #end: { readonly reason: unknown } | null = null;
  #wake: () => void = () => undefined;

  constructor(most: number) {
    this.#most = most;
  }

  /** Takes the place of what has the same key. Beyond the bound the oldest is dropped, and counted. */
  push(key: unknown, value: T): void {
    if (this.#end !== null) {
      return;
    }
    this.#waiting.set(key, value);
    if (this.#waiting.size > this.#most) {
      const [oldest] = this.#waiting.keys();
      this.#waiting.delete(oldest);
      this.#lost += 1;
    }
    this.#wake();
  }

  /** How many were dropped since this was asked last. */
  takeLost(): number {
    const lost = this.#lost;
    this.#lost = 0;
    return lost;
  }

  /** Nothing comes any more; what waits is still read. `reason`: thrown to the reader then; without one it just ends. */
  end(reason?: unknown): void {
    this.#end ??= { reason };
    this.#wake();
  }

  /** Waits for the next one; undefined: it has ended. Rejects with the reason of the signal, or of the end. */
  async next(signal?: AbortSignal): Promise<{ readonly value: T } | undefined> {
    for (;;) {
      signal?.throwIfAborted();
      for (const [key, value] of this.#waiting) {
        this.#waiting.delete(key);
        return { value };
      }
      if (this.#end !== null) {
        if (this.#end.reason !== undefined) {
          throw this.#end.reason;
        }
        return undefined;
      }
      await this.#woken(signal);
    }
  }

  #woken(signal: AbortSignal | undefined): Promise<void> {
    return new Promise((resolve) => {
      const wake = (): void => {
        signal?.removeEventListener('abort', wake);
        resolve();
      };
      this.#wake = wake;
      signal?.addEventListener('abort', wake, { once: true });
    });
  }
}
