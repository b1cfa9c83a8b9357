// @ts-check
/** The mission of the chosen drone: the draft as a list, and what is done with it. */
import { byId, html, renderList, setAttribute, setText } from './dom.js';
import { whyNot } from './drone.js';
import { parsePlace, placeText } from './geo.js';
import * as missions from './mission.js';
import { whyNoNumber } from './drone-panel.js';

/**
 * @typedef {import('./mission.js').Draft} Draft
 * @typedef {import('./mission.js').Waypoint} Waypoint
 * @typedef {import('./drone.js').Drone} Drone
 * @typedef {{ chosen(): Drone | null, draft(): Draft, setDraft(draft: Draft): void }} Page
 */

export class MissionPanel {
  #page;
  #panel;

  /** @param {Page} page @param {import('./drone-panel.js').DronePanel} panel */
  constructor(page, panel) {
    this.#page = page;
    this.#panel = panel;
    panel.button(
      'upload',
      'uploadMission',
      'uploadMission',
      () => this.#upload(),
      () => this.#whyNoUpload(),
    );
    const mission = () => page.chosen()?.mission;
    panel.button(
      'start',
      'startMission',
      'startMission',
      () => panel.send('startMission', startName(page.chosen())),
      () => (missions.isRunning(mission()) ? 'The mission is running.' : null),
    );
    panel.button(
      'pause',
      'pauseMission',
      'pauseMission',
      () => panel.send('pauseMission', 'Pause the mission'),
      () => (missions.isRunning(mission()) ? null : 'No mission is running.'),
    );
    panel.button(
      'clear',
      'clearMission',
      'clearMission',
      () => panel.send('clearMission', 'Delete the mission on the drone'),
      () => (mission()?.items?.length === 0 ? 'There is no mission on the drone.' : null),
    );
    byId('load').addEventListener('click', () => this.#load());
    byId('discard').addEventListener('click', () => page.setDraft(missions.emptyDraft()));
    // Not "change", which comes after the page was drawn anew for the input.
    byId('ending').addEventListener('input', () => {
      page.setDraft({ ...page.draft(), ending: byId('ending').value });
    });
  }

  /** @param {import('./geo.js').Place} place */
  add(place) {
    const draft = this.#page.draft();
    const wrong = whyNoNumber('waypoint-height');
    if (wrong !== null || draft.waypoints.length >= missions.MOST_WAYPOINTS) {
      this.#panel.say(wrong ?? `A mission has at most ${missions.MOST_WAYPOINTS} waypoints here.`);
      return;
    }
    this.#page.setDraft(missions.withWaypoint(draft, place, byId('waypoint-height').valueAsNumber));
  }

  async #upload() {
    const draft = this.#page.draft();
    const label = `Upload the mission of ${missions.waypointsText(draft.waypoints.length)}`;
    await this.#panel.send('uploadMission', label, { items: missions.itemsOf(draft) });
  }

  #whyNoUpload() {
    const { waypoints, leftOut } = this.#page.draft();
    if (leftOut > 0) {
      return `${leftOut} items of the drone's mission cannot be shown here and would be lost: clear the draft first.`;
    }
    return waypoints.length === 0 ? 'Add waypoints first.' : null;
  }

  #load() {
    const items = this.#page.chosen()?.mission.items ?? [];
    if (items.length === 0) {
      this.#panel.say('Nothing was loaded: the server knows of no mission on the drone.');
      return;
    }
    const draft = missions.draftOf(items);
    this.#page.setDraft(draft);
    this.#panel.say(`Loaded from the drone: ${missions.waypointsText(draft.waypoints.length)}.`, 'note');
  }

  render() {
    const drone = this.#page.chosen();
    if (drone === null) {
      return;
    }
    const draft = this.#page.draft();
    const empty = draft.waypoints.length === 0 && draft.leftOut === 0;
    const onBoard = !empty && missions.isOnBoard(draft, drone.mission.items ?? []);
    setText(
      byId('on-board'),
      [missions.onBoardText(drone.mission), drone.mission.notice].filter(Boolean).join(' '),
    );
    setText(byId('draft-state'), empty ? 'No draft' : onBoard ? 'On the drone' : 'Draft · not on the drone');
    setAttribute(byId('draft-state'), 'data-tone', empty ? 'neutral' : onBoard ? 'good' : 'planned');
    setText(byId('start-name'), startName(drone));
    byId('start-warning').hidden = empty || onBoard || whyNot(drone, 'startMission') !== null;
    byId('draft-empty').hidden = !empty;
    byId('draft-tools').hidden = empty;
    byId('ending').value = draft.ending;
    renderList(
      byId('waypoints'),
      draft.waypoints,
      (waypoint) => String(waypoint.key),
      (waypoint) => this.#row(waypoint.key),
      (child, waypoint, index) => this.#update(child, waypoint, index, draft.waypoints.length),
    );
  }

  /** @param {number} key */
  #row(key) {
    const number = html('span', { class: 'number', 'aria-hidden': 'true' });
    const place = html('input', { class: 'place', type: 'text', spellcheck: 'false', autocomplete: 'off' });
    const height = html('input', {
      class: 'height',
      type: 'number',
      min: '-500',
      max: '10000',
      step: 'any',
      required: '',
    });
    place.addEventListener('change', () => {
      const parsed = parsePlace(place.value);
      place.setAttribute('aria-invalid', String(parsed === null));
      if (parsed === null) {
        this.#panel.say('The waypoint stays where it was: write latitude, longitude in degrees.');
      } else {
        this.#page.setDraft(missions.withChange(this.#page.draft(), key, parsed));
      }
    });
    height.addEventListener('change', () => {
      if (height.validity.valid) {
        this.#page.setDraft(missions.withChange(this.#page.draft(), key, { altitude: height.valueAsNumber }));
      } else {
        this.#panel.say('The height stays as it was: it must be a number of metres from -500 to 10000.');
      }
    });
    const earlier = this.#tool('↑', () => missions.shifted(this.#page.draft(), key, -1));
    const later = this.#tool('↓', () => missions.shifted(this.#page.draft(), key, 1));
    const gone = this.#tool('✕', () => missions.without(this.#page.draft(), key));
    const tools = html('span', { class: 'tools' }, earlier, later, gone);
    return html('li', {}, number, place, height, html('span', { class: 'unit' }, 'm'), tools);
  }

  /** @param {string} symbol @param {() => Draft} change */
  #tool(symbol, change) {
    const button = html('button', { type: 'button', class: 'icon' }, symbol);
    button.addEventListener('click', () => this.#page.setDraft(change()));
    return button;
  }

  /** @param {HTMLLIElement} child @param {Waypoint} waypoint @param {number} index @param {number} count */
  #update(child, waypoint, index, count) {
    const [number, place, height, unit, tools] = /** @type {any[]} */ ([...child.children]);
    const [earlier, later, gone] = tools.children;
    const name = `Waypoint ${index + 1}`;
    setText(number, String(index + 1));
    setText(unit, waypoint.altitudeReference === 'amsl' ? 'm AMSL' : 'm');
    for (const [field, text] of [
      [place, placeText(waypoint)],
      [height, String(waypoint.altitude)],
    ]) {
      // What somebody is writing is left alone.
      if (field !== document.activeElement && field.value !== text) {
        field.value = text;
      }
    }
    setAttribute(place, 'aria-label', `${name}: latitude, longitude`);
    setAttribute(height, 'aria-label', `${name}: height in metres`);
    setAttribute(earlier, 'aria-label', `${name}: earlier`);
    setAttribute(later, 'aria-label', `${name}: later`);
    setAttribute(gone, 'aria-label', `${name}: delete`);
    earlier.disabled = index === 0;
    later.disabled = index === count - 1;
  }
}

/** @param {Drone | null} drone */
function startName(drone) {
  return drone?.mission.state === 'paused' ? 'Continue mission' : 'Start mission';
}
