// @ts-check
/** The drones as the server last told them: asked for once a second while somebody looks at the page. */
import { isSignedOut, Problem, sentenceOf } from './api.js';

const EVERY_MILLISECONDS = 1000;
const MOST_MILLISECONDS = 8000;
/** "Copter 2" before "Copter 10". */
const byName = new Intl.Collator('en', { numeric: true });

export class Fleet {
  /** @type {import('./drone.js').Drone[]} */
  drones = [];
  /** By this machine's clock; null: never. @type {number | null} */
  answeredAt = null;
  /** Why the newest question has no answer. @type {string | null} */
  problem = null;
  /** When the first question was asked that has no answer yet. @type {number | null} */
  #since = null;
  #api;
  #onChange;
  #failures = 0;
  /** Only the newest loop goes on. */
  #loop = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {import('./api.js').Api} api @param {() => void} onChange */
  constructor(api, onChange) {
    this.#api = api;
    this.#onChange = onChange;
    document.addEventListener('visibilitychange', () => {
      if (this.#loop > 0 && !document.hidden) {
        this.start();
      }
    });
  }

  /** How long the server has not answered; 0: it has answered the newest question. */
  get silentMilliseconds() {
    return this.#since === null ? 0 : Date.now() - this.#since;
  }

  /** Asks at once, and from then on. */
  start() {
    // Nobody was asked while nobody looked.
    this.#since = null;
    clearTimeout(this.#timer);
    this.#loop = Math.abs(this.#loop) + 1;
    void this.#ask(this.#loop);
  }

  stop() {
    clearTimeout(this.#timer);
    this.#loop = -Math.abs(this.#loop);
  }

  /** Until the next question; the longer nobody answers, the longer. */
  get waitMilliseconds() {
    return Math.min(MOST_MILLISECONDS, EVERY_MILLISECONDS * 2 ** Math.max(0, this.#failures - 1));
  }

  /** @param {number} loop */
  async #ask(loop) {
    this.#since ??= Date.now();
    try {
      const { drones } = await this.#api.call('getDronesList');
      if (loop !== this.#loop) {
        return;
      }
      this.drones = [...(drones ?? [])].sort((one, other) => byName.compare(one.name, other.name));
      this.answeredAt = Date.now();
      this.problem = null;
      this.#since = null;
      this.#failures = 0;
    } catch (error) {
      if (loop !== this.#loop || isSignedOut(error)) {
        return;
      }
      this.problem = whyNoAnswer(error);
      this.#failures += 1;
    }
    this.#onChange();
    if (!document.hidden) {
      this.#timer = setTimeout(() => void this.#ask(loop), this.waitMilliseconds);
    }
  }
}

/** Nothing was to be carried out: only who does not answer matters. @param {unknown} error */
function whyNoAnswer(error) {
  switch (error instanceof Problem ? error.code : null) {
    case 'proxy-server-unreachable':
      return 'The Dronemap server cannot be reached.';
    case 'proxy-server-timeout':
      return 'The Dronemap server does not answer.';
    default:
      return sentenceOf(error);
  }
}
