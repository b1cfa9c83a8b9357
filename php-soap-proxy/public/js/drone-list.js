// @ts-check
/** The list of drones: what each is called, where its link comes from, and how it is. */
import { byId, html, renderList, setAttribute, setText } from './dom.js';
import { armedText, fixed, linkText, placeOf, statusOf, UNKNOWN, updateText } from './drone.js';
import { placeText } from './geo.js';

/** @typedef {import('./drone.js').Drone} Drone */

const PARTS = ['symbol', 'name', 'height', 'status', 'age', 'mode', 'battery', 'link', 'place'];
const SYMBOLS = { neutral: '○', good: '●', look: '▲', act: '✕' };

/**
 * @param {readonly Drone[]} drones @param {string | null} chosen @param {number} now
 * @param {(id: string) => void} choose
 */
export function renderDrones(drones, chosen, now, choose) {
  setText(byId('drone-count'), String(drones.length));
  byId('no-drones').hidden = drones.length > 0;
  renderList(
    byId('drone-list'),
    drones,
    (drone) => drone.id,
    (drone) => row(drone, choose),
    (child, drone) => update(child, drone, drone.id === chosen, now),
  );
  updateLine(drones.find((drone) => drone.id === chosen));
}

/** On a phone the list folds to the chosen drone, until one wants another. @param {boolean} folded */
export function foldDrones(folded) {
  byId('drones').classList.toggle('folded', folded);
  setAttribute(byId('drone-line'), 'aria-expanded', String(!folded));
}

/** @param {Drone | undefined} drone the chosen one */
function updateLine(drone) {
  const line = byId('drone-line');
  line.hidden = drone === undefined;
  byId('drones').classList.toggle('chosen', drone !== undefined);
  if (drone !== undefined) {
    const { words, tone } = statusOf(drone);
    const height = fixed(drone.position?.altitudeAboveHome);
    setAttribute(line, 'data-tone', tone);
    setText(line.querySelector('.symbol'), SYMBOLS[tone]);
    setText(line.querySelector('.name'), drone.name);
    setText(line.querySelector('.status'), `${height} m · ${words}`);
    const isFolded = line.getAttribute('aria-expanded') === 'false';
    setText(line.querySelector('.change'), isFolded ? 'Change ▾' : 'Close ▴');
  }
}

/** @param {Drone} drone @param {(id: string) => void} choose */
function row(drone, choose) {
  const parts = PARTS.map((name) => html('span', { class: name }));
  parts[0]?.setAttribute('aria-hidden', 'true');
  // With spaces between them, for who listens.
  const button = html(
    'button',
    { type: 'button', class: 'drone-row' },
    ...parts.flatMap((part) => [part, ' ']),
  );
  button.addEventListener('click', () => choose(drone.id));
  return html('li', {}, button);
}

/** @param {HTMLLIElement} child @param {Drone} drone @param {boolean} chosen @param {number} now */
function update(child, drone, chosen, now) {
  const button = child.firstElementChild;
  const { words, tone } = statusOf(drone);
  const place = placeOf(drone);
  const { altitudeAboveHome = null, altitudeAmsl = null } = drone.position ?? {};
  const texts = {
    symbol: SYMBOLS[tone],
    name: drone.name,
    height: `${fixed(altitudeAboveHome, 1)} m`,
    status: words,
    mode: `${drone.mode ?? UNKNOWN} · ${armedText(drone)}`,
    battery: `Battery ${drone.battery?.percent ?? UNKNOWN} %`,
    link: linkText(drone),
    place: place === null ? 'Position unknown' : `${placeText(place)} · ${fixed(altitudeAmsl)} m AMSL`,
    age: `Updated ${updateText(drone, now)}`,
  };
  for (const [name, text] of Object.entries(texts)) {
    const part = button?.querySelector(`.${name}`);
    if (part) {
      setText(part, text);
    }
  }
  if (button) {
    setAttribute(button, 'aria-pressed', String(chosen));
    setAttribute(button, 'data-tone', tone);
  }
}
