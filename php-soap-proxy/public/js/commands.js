// @ts-check
/** Commands from the press of a button to an outcome in words; none is forgotten before it has one. */
import { isBroken, isSignedOut, isUnsent, Problem, sentenceOf } from './api.js';
import { outcomeOf, uncertainWords } from './outcome.js';
import { isFlight, progressOf } from './progress.js';

/**
 * @typedef {import('./outcome.js').Result} Result
 * @typedef {{ id: string, droneId: string, droneName: string, operation: string, label: string, at: number,
 *   result: Result, words: string, sent: boolean, open: boolean, session: string,
 *   goal: (import('./geo.js').Place & { altitude: number }) | null, finished: number | null, mode: string | null,
 *   progress: import('./progress.js').Progress | null }} Entry
 * `sent`: whether the server has confirmed that it knows the command; `open`: whether it is still asked about;
 * `goal`: where it is to fly, or how high; `finished`: when its outcome came; `mode`: of the drone then.
 */

const ENTRIES = 'dronemap-commands';
const ANSWER_SECONDS = 5;
const ASK_MILLISECONDS = 1000;
/** A request without an answer may still be on its way for this many answers that nobody knows it. */
const ENOUGH_DENIALS = 6;
const MOST_ENTRIES = 50;

/** @param {number} milliseconds @returns {Promise<void>} */
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** An id of 24 letters and digits: the server acts once on it, however often it comes. */
export function newId() {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

export class Commands {
  /** Which session asks now: another one may not be told what became of a command. */
  session = '';
  /** Who gave them, as the server told with the newest; null: it has not told yet. @type {string | null} */
  user = null;
  /** Newest first. @type {Entry[]} */
  entries = [];
  #api;
  #onChange;

  /** @param {import('./api.js').Api} api @param {() => void} onChange */
  constructor(api, onChange) {
    this.#api = api;
    this.#onChange = onChange;
    /** @type {Entry[]} */
    const kept = JSON.parse(sessionStorage.getItem(ENTRIES) ?? '[]');
    const doubt = {
      result: /** @type {const} */ ('unknown'),
      words: uncertainWords('The page was loaded anew.'),
    };
    this.entries = kept.map((entry) => (entry.open ? { ...entry, ...doubt } : entry));
  }

  /** Goes on with what an earlier load of this page has left open. */
  resume() {
    for (const entry of this.entries) {
      if (entry.open) {
        void this.#follow(entry);
      }
    }
  }

  /** @param {string} droneId @returns {Entry | undefined} */
  newest(droneId) {
    return this.entries.find((entry) => entry.droneId === droneId);
  }

  /** What the drone is at. @param {string} droneId @returns {Entry | undefined} */
  newestFlight(droneId) {
    return this.entries.find((entry) => entry.droneId === droneId && isFlight(entry));
  }

  /** Looks how far each drone is. @param {readonly import('./drone.js').Drone[]} drones */
  watch(drones) {
    for (const drone of drones) {
      const entry = this.newestFlight(drone.id);
      // A place that was reached stays reached.
      if (entry?.result === 'succeeded' && (entry.progress?.state !== 'done' || drone.armed === false)) {
        entry.progress = progressOf(entry, drone);
        if (entry.progress !== null && entry.progress.state !== 'goesOn') {
          entry.words = `Succeeded: ${entry.progress.words}.`;
        }
      }
    }
  }

  /** @param {string} droneId @param {string} operation */
  isBusy(droneId, operation) {
    return this.entries.some(
      (one) => one.droneId === droneId && one.operation === operation && one.result === 'busy',
    );
  }

  /**
   * Answers the entry with its outcome, or with "not known" if that could not be had.
   * @param {{ id: string, name: string }} drone @param {string} operation @param {string} label
   * @param {object} [parameters] @param {() => Promise<void>} [prepare] fails when the command must not be sent
   * @returns {Promise<Entry>}
   */
  async send(drone, operation, label, parameters = {}, prepare = async () => {}) {
    /** @type {Entry} */
    const entry = {
      ...{ id: newId(), droneId: drone.id, droneName: drone.name, operation, label, at: Date.now() },
      ...{ result: 'busy', words: 'Sending…', sent: false, open: true, session: this.session },
      ...{
        goal: 'altitude' in parameters ? /** @type {any} */ (parameters) : null,
        finished: null,
        mode: null,
        progress: null,
      },
    };
    this.entries.unshift(entry);
    this.entries = this.entries.filter(({ open }, index) => open || index < MOST_ENTRIES);
    this.#changed();
    try {
      await prepare();
    } catch (error) {
      const result = isBroken(error) ? 'notSent' : 'refused';
      this.#close(entry, result, `Not sent, since control could not be taken: ${sentenceOf(error)}`);
      return entry;
    }
    const body = { droneId: drone.id, ...parameters, id: entry.id, wait: ANSWER_SECONDS };
    try {
      this.#apply(entry, await this.#api.call(operation, body));
    } catch (error) {
      this.#fail(entry, error);
    }
    await this.#follow(entry);
    return entry;
  }

  /** Asks the server until there is an outcome. @param {Entry} entry */
  async #follow(entry) {
    let denials = 0;
    while (entry.open) {
      await pause(ASK_MILLISECONDS);
      // Between sessions there is nobody to ask as.
      if (!this.#api.hasToken) {
        continue;
      }
      try {
        this.#apply(entry, await this.#api.call('getCommand', { commandId: entry.id }));
      } catch (error) {
        denials += isDenial(error) ? 1 : 0;
        this.#unanswered(entry, error, denials);
      }
    }
  }

  /** @param {Entry} entry @param {any} view of SOAP */
  #apply(entry, view) {
    const { outcome, phase, progress } = view;
    entry.sent = true;
    this.user = view.by;
    if (outcome) {
      [entry.result, entry.words] = outcomeOf(entry.operation, outcome);
      entry.open = false;
      entry.finished = Date.now();
    } else {
      const part = progress ? ` ${progress.done} of ${progress.total}` : '';
      entry.result = 'busy';
      entry.words =
        phase === 'accepted' ? `Accepted${part}, under way…` : `Sent${part}, waiting for the drone…`;
    }
    const [warning] = view.warnings ?? [];
    entry.words += warning === undefined ? '' : ` Note: ${warning}`;
    this.#changed();
  }

  /** @param {Entry} entry @param {unknown} error */
  #fail(entry, error) {
    if (isSignedOut(error)) {
      this.#close(entry, 'notSent', 'Not sent: your session has ended. Sign in, then press again.');
    } else if (isUnsent(error)) {
      this.#close(entry, 'notSent', `Not sent: ${sentenceOf(error)}`);
    } else if (isBroken(error)) {
      this.#doubt(entry, error);
    } else {
      this.#close(entry, 'refused', `Refused by the server, nothing was sent: ${sentenceOf(error)}`);
    }
  }

  /** @param {Entry} entry @param {unknown} error @param {number} denials how often the server did not know it */
  #unanswered(entry, error, denials) {
    if (isBroken(error) || isTooOften(error)) {
      this.#doubt(entry, error);
    } else if (!isDenial(error)) {
      this.#close(
        entry,
        'unknown',
        `What became of it cannot be asked: ${sentenceOf(error)} Look at the drone.`,
      );
    } else if (denials >= ENOUGH_DENIALS && (entry.sent || entry.session !== this.session)) {
      this.#close(
        entry,
        'unknown',
        'The server does not tell any more what became of it. Look at the drone.',
      );
    } else if (denials >= ENOUGH_DENIALS) {
      const words = 'Not carried out: it did not reach the server. Press again if you still mean it.';
      this.#close(entry, 'notSent', words);
    }
  }

  /** @param {Entry} entry @param {Result} result @param {string} words */
  #close(entry, result, words) {
    Object.assign(entry, { result, words, open: false });
    this.#changed();
  }

  /** @param {Entry} entry @param {unknown} error */
  #doubt(entry, error) {
    Object.assign(entry, { result: 'unknown', words: uncertainWords(sentenceOf(error)) });
    this.#changed();
  }

  #changed() {
    sessionStorage.setItem(ENTRIES, JSON.stringify(this.entries));
    this.#onChange();
  }
}

/** Whether the server says that there is no such command. @param {unknown} error */
function isDenial(error) {
  return error instanceof Problem && error.code === 'command-unknown';
}

/** @param {unknown} error */
function isTooOften(error) {
  return error instanceof Problem && error.status === 429;
}
