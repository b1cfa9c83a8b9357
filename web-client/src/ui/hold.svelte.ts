export const HOLD_MILLISECONDS = 800;

export interface HoldClock {
  now(): number;
  after(milliseconds: number, action: () => void): () => void;
  onFrame(action: () => void): () => void;
}

const browserClock: HoldClock = {
  now: () => performance.now(),
  after: (milliseconds, action) => {
    const handle = setTimeout(action, milliseconds);
    return () => clearTimeout(handle);
  },
  onFrame: (action) => {
    const handle = requestAnimationFrame(action);
    return () => cancelAnimationFrame(handle);
  },
};

/**
 * A press that only counts when it is held for 0.8 s; `progress` runs from 0 to 1 for the ring. What counts are the
 * times of the input events (their time stamps), not when a busy page handled them.
 */
export class Hold {
  progress = $state(0);
  /** True after a press that was let go too early: the moment to say that it wants holding. */
  tooShort = $state(false);
  readonly #confirm: () => void;
  readonly #clock: HoldClock;
  #since: number | null = null;
  #cancelFrame: () => void = () => undefined;
  #cancelTimer: () => void = () => undefined;

  constructor(confirm: () => void, clock: HoldClock = browserClock) {
    this.#confirm = confirm;
    this.#clock = clock;
  }

  begin(at: number): void {
    if (this.#since !== null) {
      return;
    }
    this.#since = at;
    this.tooShort = false;
    const left = Math.max(0, HOLD_MILLISECONDS - (this.#clock.now() - at));
    // A release that waits in the queue comes first: only then is the time up.
    this.#cancelTimer = this.#clock.after(left, () => {
      this.#cancelTimer = this.#clock.after(0, () => this.#complete());
    });
    this.#draw();
  }

  release(at: number): void {
    if (this.#since === null) {
      return;
    }
    if (at - this.#since >= HOLD_MILLISECONDS) {
      this.#complete();
    } else {
      this.#stop();
      this.tooShort = true;
    }
  }

  /** The press has left the control: that is a change of mind, not a mistake. */
  abandon(): void {
    this.#stop();
    this.tooShort = false;
  }

  #complete(): void {
    this.#stop();
    this.#confirm();
  }

  #draw(): void {
    if (this.#since !== null) {
      this.progress = Math.min(1, Math.max(0, (this.#clock.now() - this.#since) / HOLD_MILLISECONDS));
      this.#cancelFrame = this.#clock.onFrame(() => this.#draw());
    }
  }

  #stop(): void {
    this.#cancelFrame();
    this.#cancelTimer();
    this.#since = null;
    this.progress = 0;
  }
}
