// @ts-check
/** The bar at the foot: control that has ended, what became of the newest command, and what the drone does since. */
import { lostText } from './control.js';
import { byId, html, renderList, setAttribute, setText } from './dom.js';
import { spanText } from './drone.js';

/**
 * @typedef {import('./drone.js').Drone} Drone
 * @typedef {import('./commands.js').Entry} Entry
 * @typedef {{
 *   commands: import('./commands.js').Commands, control: import('./control.js').Control,
 *   chosen(): Drone | null, now(): number, whyNoCommand(): string | null,
 * }} Page
 */

/** @type {Record<string, string>} */
const SYMBOLS = { busy: '…', succeeded: '✓', unknown: '?', superseded: '↷', note: 'i' };
/** How a flight that goes on looks. */
const RESULTS = { goesOn: 'busy', done: 'succeeded', ended: 'superseded' };

export class Foot {
  /** Said in the place of the outcome, until there is a newer one. */
  hint = '';
  #tone = 'hint';
  /** The outcome that it stands in the place of. */
  #hidden = '';
  #page;

  /** @param {Page} page */
  constructor(page) {
    this.#page = page;
    byId('alarm-take').addEventListener('click', () => {
      const drone = this.#lost();
      if (drone !== undefined) {
        void page.control.take(drone.id);
      }
    });
  }

  /** @param {string} words @param {'hint' | 'note'} tone */
  say(words, tone) {
    this.hint = words;
    this.#tone = tone;
    this.#hidden = outcomeText(this.#newest());
    this.render();
  }

  render() {
    this.#renderAlarm();
    this.#renderOutcome();
    this.#renderLog();
  }

  /** The drone that most needs somebody to take control. */
  #lost() {
    const { lost } = this.#page.control;
    return lost.find((drone) => drone === this.#page.chosen()) ?? lost[0];
  }

  #renderAlarm() {
    const drone = this.#lost();
    const problem = drone && this.#page.control.problems.get(drone.id);
    setText(byId('alarm-words'), drone === undefined ? '' : lostText(drone));
    setText(byId('alarm-left'), drone === undefined ? '' : leftText(drone, this.#page.now()));
    setText(byId('alarm-problem'), problem ?? '');
    byId('alarm-take').hidden = drone === undefined || drone.control.state === 'held';
  }

  #newest() {
    const drone = this.#page.chosen();
    return drone === null ? undefined : this.#page.commands.newest(drone.id);
  }

  #renderOutcome() {
    const entry = this.#newest();
    if (outcomeText(entry) !== this.#hidden) {
      this.hint = '';
    }
    const isHint = this.hint !== '';
    const progress = isHint ? null : (entry?.progress ?? null);
    // Nobody hears how the flight goes on: what stands there is what was heard last.
    const unheard = progress?.state === 'goesOn' ? this.#page.whyNoCommand() : null;
    const result = unheard !== null ? 'unknown' : isHint ? this.#tone : progress ? RESULTS[progress.state] : (entry?.result ?? 'none');
    setAttribute(byId('outcome'), 'data-result', result);
    setText(byId('outcome-symbol'), result === 'none' ? '' : (SYMBOLS[result] ?? '!'));
    const heard = unheard === null ? '' : `${unheard} Last heard: `;
    const told = progress ? `${heard}${entry?.label}: ${progress.words}` : outcomeText(entry);
    setText(byId('outcome-words'), isHint ? this.hint : told);
    setText(byId('outcome-figures'), progress ? `${progress.figures}.` : '');
  }

  #renderLog() {
    const { entries } = this.#page.commands;
    byId('log-section').hidden = entries.length === 0;
    renderList(
      byId('log'),
      entries,
      (entry) => entry.id,
      () =>
        html(
          'li',
          {},
          html('span', { class: 'symbol', 'aria-hidden': 'true' }),
          html('p', {}, html('b'), html('span')),
        ),
      (child, entry) => {
        setAttribute(child, 'data-result', entry.result);
        setText(child.querySelector('.symbol'), SYMBOLS[entry.result] ?? '!');
        const time = new Date(entry.at).toLocaleTimeString('en-GB');
        setText(child.querySelector('b'), `${time} · ${entry.droneName} · ${entry.label}`);
        setText(child.querySelector('p span'), ` ${entry.words}`);
      },
    );
  }
}

/** How long until it is brought home. @param {Drone} drone @param {number} now */
export function leftText({ outlook }, now) {
  const returnsAt = outlook?.returnsAt ?? null;
  return returnsAt === null ? '' : ` In ${spanText(Date.parse(returnsAt) - now)}.`;
}

/** @param {Entry | undefined} entry */
function outcomeText(entry) {
  return entry === undefined ? '' : `${entry.label}. ${entry.words}`;
}
