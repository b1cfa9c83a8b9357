// @ts-check
/** The map: what it shows of the page's state, and what clicks on it mean. */
import { byId, setText, svg } from './dom.js';
import * as drawing from './drawing.js';
import { placeOf } from './drone.js';
import { placeText } from './geo.js';
import { Gestures } from './gestures.js';
import { isOnBoard } from './mission.js';
import { View } from './view.js';

/**
 * @typedef {import('./geo.js').Place} Place
 * @typedef {import('./geo.js').Point} Point
 * @typedef {'look' | 'fly' | 'waypoints'} Tool what a click means: choose a drone, place the target, add a waypoint
 * @typedef {{
 *   drones: readonly import('./drone.js').Drone[], chosen: import('./drone.js').Drone | null,
 *   draft: import('./mission.js').Draft, target: Place | null, tool: Tool,
 *   tracks: ReadonlyMap<string, readonly Place[]>,
 * }} Scene
 * @typedef {{
 *   scene(): Scene, choose(id: string): void, setTarget(place: Place): void, addWaypoint(place: Place): void,
 *   moveWaypoint(key: number, place: Place): void,
 * }} Page
 */

const NEAR_PIXELS = 22;
const ZOOM_STEP = 1.6;

export class FlightMap {
  #view = new View();
  #root = byId('map');
  #page;
  #asked = false;
  #fitted = false;

  /** @param {Page} page */
  constructor(page) {
    this.#page = page;
    new Gestures(this.#root, {
      waypointAt: (point) => this.#waypointAt(point),
      onClick: (point) => this.#click(point),
      onDragWaypoint: (key, point) => page.moveWaypoint(key, this.#view.toPlace(point)),
      onPan: (x, y) => this.#change(() => this.#view.pan(x, y)),
      onZoom: (factor, at) => this.#change(() => this.#view.zoom(factor, at)),
      onShowAll: () => this.showAll(),
      onCenter: () => this.#click({ x: this.#view.width / 2, y: this.#view.height / 2 }),
    });
    byId('zoom-in').addEventListener('click', () => this.#change(() => this.#view.zoom(ZOOM_STEP)));
    byId('zoom-out').addEventListener('click', () => this.#change(() => this.#view.zoom(1 / ZOOM_STEP)));
    byId('show-all').addEventListener('click', () => this.showAll());
    this.#root.addEventListener('pointermove', (/** @type {PointerEvent} */ event) => {
      if (event.pointerType !== 'mouse') {
        return;
      }
      const box = this.#root.getBoundingClientRect();
      const place = this.#view.toPlace({ x: event.clientX - box.left, y: event.clientY - box.top });
      setText(byId('map-place'), placeText(place));
    });
    this.#root.addEventListener('pointerleave', () => setText(byId('map-place'), ''));
    new ResizeObserver(() => this.#resize()).observe(this.#root);
  }

  showAll() {
    const { drones, chosen, draft, target } = this.#page.scene();
    const places = [...drones.map(placeOf), chosen?.home ?? null, ...draft.waypoints, target];
    this.#change(() => this.#view.fit(places.filter((place) => place !== null)));
  }

  /** @param {Place | null} place */
  show(place) {
    if (place !== null) {
      this.#fitted = true;
      this.#change(() => this.#view.show(place));
    }
  }

  /** At the next picture; however often it is asked for until then. */
  draw() {
    if (!this.#asked) {
      this.#asked = true;
      requestAnimationFrame(() => {
        this.#asked = false;
        this.#drawNow();
      });
    }
  }

  #resize() {
    const { width, height } = this.#root.getBoundingClientRect();
    this.#change(() => Object.assign(this.#view, { width: Math.max(1, width), height: Math.max(1, height) }));
  }

  /** @param {() => void} action */
  #change(action) {
    action();
    this.draw();
  }

  #drawNow() {
    const { drones, chosen, draft, target, tracks, tool } = this.#page.scene();
    if (!this.#fitted && this.#view.width > 1 && drones.some((drone) => placeOf(drone) !== null)) {
      this.#fitted = true;
      this.showAll();
    }
    const view = this.#view;
    const track = chosen === null ? [] : (tracks.get(chosen.id) ?? []);
    this.#root.replaceChildren(
      ...drawing.grid(view),
      ...[...tracks].flatMap(([id, places]) =>
        id === chosen?.id ? [] : drawing.line(view, places, 'track'),
      ),
      ...drawing.line(view, track, 'track chosen'),
      ...(chosen === null ? [] : drawing.boardMission(view, chosen)),
      // What is on board is drawn as that.
      ...(isOnBoard(draft, chosen?.mission.items ?? []) ? [] : this.#draftMarks(draft)),
      ...(chosen?.home ? [drawing.homeMark(view, chosen.home)] : []),
      svg('g', {}, ...drawing.droneMarks(view, drones, chosen?.id ?? null, this.#marked())),
      ...(target === null ? [] : [drawing.targetMark(view, target)]),
      ...drawing.scaleBar(view),
      ...(tool === 'look' ? [] : drawing.crosshair(view)),
    );
  }

  /** Places with marks of their own, beside the drones. @returns {Place[]} */
  #marked() {
    const { chosen, draft, target } = this.#page.scene();
    const board = (chosen?.mission.items ?? []).flatMap((item) => item.waypoint ?? []);
    const places = [chosen?.home ?? null, target, ...draft.waypoints, ...board];
    return places.filter((place) => place !== null);
  }

  /** @param {import('./mission.js').Draft} draft */
  #draftMarks({ waypoints }) {
    const marks = waypoints.map((waypoint, index) =>
      drawing.numbered(this.#view, waypoint, 'draft', String(index + 1)),
    );
    return [...drawing.line(this.#view, waypoints, 'draft-way'), ...marks];
  }

  /** @param {Point} point */
  #click(point) {
    const { tool, drones } = this.#page.scene();
    if (tool === 'fly') {
      this.#page.setTarget(this.#view.toPlace(point));
    } else if (tool === 'waypoints') {
      if (this.#waypointAt(point) === null) {
        this.#page.addWaypoint(this.#view.toPlace(point));
      }
    } else {
      const places = drones.map((drone) => ({ key: drone.id, place: placeOf(drone) }));
      const found = this.#nearest(point, places);
      if (found !== null) {
        this.#page.choose(found);
      }
    }
  }

  /** Only while waypoints are planned: no other drag of the map moves one. @param {Point} point */
  #waypointAt(point) {
    const { tool, draft } = this.#page.scene();
    const places = draft.waypoints.map((waypoint) => ({ key: waypoint.key, place: waypoint }));
    return tool === 'waypoints' ? this.#nearest(point, places) : null;
  }

  /**
   * @template T
   * @param {Point} point @param {{ key: T, place: Place | null }[]} places
   * @returns {T | null}
   */
  #nearest(point, places) {
    let best = null;
    let least = NEAR_PIXELS;
    for (const { key, place } of places) {
      if (place !== null) {
        const { x, y } = this.#view.toPixels(place);
        const away = Math.hypot(x - point.x, y - point.y);
        [best, least] = away < least ? [key, away] : [best, least];
      }
    }
    return best;
  }
}
