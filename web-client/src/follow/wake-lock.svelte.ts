/** unsupported: this browser cannot; refused: it would not, as in power saving. */
export type WakeState = 'off' | 'held' | 'lost' | 'refused' | 'unsupported';

type Page = Pick<Document, 'visibilityState' | 'addEventListener' | 'removeEventListener'>;

/** Keeps the screen on while it is wanted. The system takes that away whenever the page is hidden; it is asked for again. */
export class ScreenWakeLock {
  state = $state<WakeState>('off');
  readonly #lock: WakeLock | undefined;
  readonly #page: Page;
  #wanted = false;
  #held: WakeLockSentinel | null = null;
  #asking = false;
  readonly #onVisible = (): void => {
    if (this.#page.visibilityState === 'visible') {
      void this.#request();
    }
  };

  constructor(
    lock: WakeLock | undefined = (navigator as { wakeLock?: WakeLock }).wakeLock,
    page: Page = document,
  ) {
    this.#lock = lock;
    this.#page = page;
  }

  start(): void {
    if (!this.#wanted) {
      this.#wanted = true;
      this.#page.addEventListener('visibilitychange', this.#onVisible);
    }
    void this.#request();
  }

  stop(): void {
    this.#wanted = false;
    this.#page.removeEventListener('visibilitychange', this.#onVisible);
    const held = this.#held;
    this.#held = null;
    this.state = 'off';
    void held?.release();
  }

  async #request(): Promise<void> {
    if (this.#lock === undefined) {
      this.state = 'unsupported';
      return;
    }
    if (!this.#wanted || this.#held !== null || this.#asking || this.#page.visibilityState !== 'visible') {
      return;
    }
    this.#asking = true;
    try {
      this.#hold(await this.#lock.request('screen'));
    } catch {
      // The browser refuses, mostly to save power; a warning asks the user to keep the screen on.
      this.state = 'refused';
    } finally {
      this.#asking = false;
    }
  }

  #hold(sentinel: WakeLockSentinel): void {
    if (!this.#wanted) {
      void sentinel.release();
      return;
    }
    this.#held = sentinel;
    this.state = 'held';
    sentinel.addEventListener('release', () => {
      if (this.#held === sentinel) {
        this.#held = null;
        this.state = 'lost';
        this.#onVisible();
      }
    });
  }
}
