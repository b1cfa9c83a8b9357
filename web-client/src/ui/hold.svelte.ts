export const HOLD_MILLISECONDS = 800;

export interface FrameClock {
  now(): number;
  onFrame(action: () => void): () => void;
}

const browserFrames: FrameClock = {
  now: () => performance.now(),
  onFrame: (action) => {
    const handle = requestAnimationFrame(action);
    return () => cancelAnimationFrame(handle);
  },
};

/** A press that only counts when it is held for 0.8 s; `progress` runs from 0 to 1 for the ring. */
export class Hold {
  progress = $state(0);
  /** True after a press that was let go too early: the moment to say that it wants holding. */
  tooShort = $state(false);
  readonly #confirm: () => void;
  readonly #frames: FrameClock;
  #since: number | null = null;
  #cancelFrame: () => void = () => undefined;

  constructor(confirm: () => void, frames: FrameClock = browserFrames) {
    this.#confirm = confirm;
    this.#frames = frames;
  }

  begin(): void {
    if (this.#since === null) {
      this.#since = this.#frames.now();
      this.tooShort = false;
      this.#cancelFrame = this.#frames.onFrame(() => this.#frame());
    }
  }

  release(): void {
    if (this.#since !== null) {
      this.#stop();
      this.tooShort = true;
    }
  }

  /** The press has left the control: that is a change of mind, not a mistake. */
  abandon(): void {
    this.#stop();
    this.tooShort = false;
  }

  #frame(): void {
    if (this.#since === null) {
      return;
    }
    this.progress = Math.min(1, (this.#frames.now() - this.#since) / HOLD_MILLISECONDS);
    if (this.progress >= 1) {
      this.#stop();
      this.#confirm();
    } else {
      this.#cancelFrame = this.#frames.onFrame(() => this.#frame());
    }
  }

  #stop(): void {
    this.#cancelFrame();
    this.#since = null;
    this.progress = 0;
  }
}
