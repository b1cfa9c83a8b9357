import type { LngLat, Map as MapLibre, MapMouseEvent, MapTouchEvent } from 'maplibre-gl';
import type { Coordinates } from '../geo/coordinates';

const LONG_PRESS_MILLISECONDS = 500;
const STILL_PIXELS = 8;

export interface PressHandler {
  /** The key of the planned waypoint under this point, or null. */
  isWaypoint(event: { point: { x: number; y: number } }): number | null;
  /** Whether it meant something here; where it did not, letting go counts as a click. */
  onPress(place: Coordinates): boolean;
  onDrop(key: number, place: Coordinates): void;
  onClick(event: MapMouseEvent): void;
}

type Press = MapMouseEvent | MapTouchEvent;

/** Tells apart a click, a long press and the dragging of a waypoint; a drag of the map is none of them. */
export class PressGestures {
  readonly #handler: PressHandler;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #start: { x: number; y: number } | null = null;
  #dragged: number | null = null;
  #moved = false;
  #swallowClick = false;

  constructor(map: MapLibre, handler: PressHandler) {
    this.#handler = handler;
    map.on('mousedown', (event) => event.originalEvent.button === 0 && this.#down(event));
    map.on('touchstart', (event) => (event.points.length === 1 ? this.#down(event) : this.#cancel()));
    map.on('mousemove', (event) => this.#move(event));
    map.on('touchmove', (event) => this.#move(event));
    map.on('mouseup', (event) => this.#up(event));
    map.on('touchend', (event) => this.#up(event));
    map.on('touchcancel', () => this.#cancel());
    map.on('dragstart', () => this.#cancel());
    map.on('contextmenu', (event) => {
      event.preventDefault();
      this.#press(event.lngLat);
    });
    map.on('click', (event) => {
      const swallow = this.#swallowClick;
      this.#swallowClick = false;
      if (!swallow) {
        handler.onClick(event);
      }
    });
  }

  #down(event: Press): void {
    this.#cancel();
    this.#swallowClick = false;
    this.#moved = false;
    this.#start = { x: event.point.x, y: event.point.y };
    this.#dragged = this.#handler.isWaypoint(event);
    if (this.#dragged !== null) {
      event.preventDefault();
      return;
    }
    const place = event.lngLat;
    this.#timer = setTimeout(() => this.#press(place), LONG_PRESS_MILLISECONDS);
  }

  #move(event: Press): void {
    if (this.#start === null) {
      return;
    }
    const far = Math.hypot(event.point.x - this.#start.x, event.point.y - this.#start.y) > STILL_PIXELS;
    if (far) {
      this.#moved = true;
      clearTimeout(this.#timer);
    }
    if (this.#dragged !== null && this.#moved) {
      event.preventDefault();
    }
  }

  #up(event: Press): void {
    if (this.#dragged !== null && this.#moved) {
      this.#swallowClick = true;
      this.#handler.onDrop(this.#dragged, plain(event.lngLat));
    }
    this.#cancel();
  }

  #press(place: LngLat): void {
    this.#cancel();
    // The finger is still down: its release must not count as a click too.
    this.#swallowClick = this.#handler.onPress(plain(place));
  }

  #cancel(): void {
    clearTimeout(this.#timer);
    this.#start = null;
    this.#dragged = null;
  }
}

function plain(place: LngLat): Coordinates {
  const { lat: latitude, lng: longitude } = place.wrap();
  return { latitude, longitude };
}
