// @ts-check
/** Tells apart on a map: a click, dragging the map, dragging a waypoint, pinching, the wheel and keys. */

/**
 * @typedef {import('./geo.js').Point} Point
 * @typedef {{
 *   waypointAt(point: Point): number | null,
 *   onClick(point: Point): void,
 *   onDragWaypoint(key: number, point: Point): void,
 *   onPan(x: number, y: number): void,
 *   onZoom(factor: number, at?: Point): void,
 *   onShowAll(): void,
 *   onCenter(): void,
 * }} Handler
 */

const STILL_PIXELS = 8;
const KEY_PIXELS = 60;
const ZOOM_STEP = 1.5;
/** @type {Record<string, [number, number]>} */
const ARROWS = {
  ArrowLeft: [KEY_PIXELS, 0],
  ArrowRight: [-KEY_PIXELS, 0],
  ArrowUp: [0, KEY_PIXELS],
  ArrowDown: [0, -KEY_PIXELS],
};

export class Gestures {
  #element;
  #handler;
  /** @type {Map<number, Point>} */
  #pointers = new Map();
  /** @type {Point | null} */
  #start = null;
  #moved = false;
  /** @type {number | null} */
  #waypoint = null;

  /** @param {SVGElement} element @param {Handler} handler */
  constructor(element, handler) {
    this.#element = element;
    this.#handler = handler;
    element.addEventListener('pointerdown', (event) => this.#down(event));
    element.addEventListener('pointermove', (event) => this.#move(event));
    element.addEventListener('pointerup', (event) => this.#up(event));
    element.addEventListener('pointercancel', (event) => this.#end(event));
    // What two fingers do is for the map, and must not scroll the page as well.
    for (const type of /** @type {const} */ (['touchstart', 'touchmove'])) {
      element.addEventListener(type, (event) => event.touches.length > 1 && event.preventDefault(), {
        passive: false,
      });
    }
    element.addEventListener('keydown', (event) => this.#key(event));
    element.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
        handler.onZoom(Math.exp(-event.deltaY * lines * 0.002), this.#pointOf(event));
      },
      { passive: false },
    );
  }

  /** @param {MouseEvent} event @returns {Point} */
  #pointOf(event) {
    const box = this.#element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  /** @param {PointerEvent} event */
  #down(event) {
    if (event.button !== 0) {
      return;
    }
    this.#element.setPointerCapture(event.pointerId);
    const point = this.#pointOf(event);
    this.#pointers.set(event.pointerId, point);
    if (this.#pointers.size === 1) {
      this.#start = point;
      this.#moved = false;
      this.#waypoint = this.#handler.waypointAt(point);
    } else {
      this.#start = null;
      this.#waypoint = null;
    }
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const before = this.#pointers.get(event.pointerId);
    if (before === undefined) {
      return;
    }
    const point = this.#pointOf(event);
    if (this.#pointers.size === 2) {
      this.#pinch(event.pointerId, before, point);
    } else if (this.#start !== null) {
      if (!this.#moved && Math.hypot(point.x - this.#start.x, point.y - this.#start.y) < STILL_PIXELS) {
        return;
      }
      this.#moved = true;
      if (this.#waypoint === null && event.pointerType === 'touch' && this.#leavesTouchToPage()) {
        return;
      }
      if (this.#waypoint === null) {
        this.#handler.onPan(point.x - before.x, point.y - before.y);
      } else {
        this.#handler.onDragWaypoint(this.#waypoint, point);
      }
    }
    this.#pointers.set(event.pointerId, point);
  }

  /** Where the page is longer than the screen, one finger scrolls it. */
  #leavesTouchToPage() {
    return getComputedStyle(this.#element).touchAction !== 'none';
  }

  /** @param {number} moved @param {Point} before @param {Point} point */
  #pinch(moved, before, point) {
    const other = [...this.#pointers].find(([id]) => id !== moved)?.[1];
    if (other === undefined) {
      return;
    }
    const apart = Math.hypot(before.x - other.x, before.y - other.y);
    const now = Math.hypot(point.x - other.x, point.y - other.y);
    this.#handler.onPan((point.x - before.x) / 2, (point.y - before.y) / 2);
    if (apart > 0 && now > 0) {
      this.#handler.onZoom(now / apart, { x: (point.x + other.x) / 2, y: (point.y + other.y) / 2 });
    }
  }

  /** @param {PointerEvent} event */
  #up(event) {
    const isClick = this.#pointers.size === 1 && this.#start !== null && !this.#moved;
    this.#end(event);
    if (isClick) {
      this.#handler.onClick(this.#pointOf(event));
    }
  }

  /** @param {PointerEvent} event */
  #end(event) {
    this.#pointers.delete(event.pointerId);
    this.#start = null;
    this.#waypoint = null;
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const arrow = ARROWS[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    if (arrow !== undefined) {
      this.#handler.onPan(...arrow);
    } else if (event.key === '+' || event.key === '=') {
      this.#handler.onZoom(ZOOM_STEP);
    } else if (event.key === '-') {
      this.#handler.onZoom(1 / ZOOM_STEP);
    } else if (event.key === '0') {
      this.#handler.onShowAll();
    } else if (event.key === 'Enter') {
      this.#handler.onCenter();
    } else {
      return;
    }
    event.preventDefault();
  }
}
