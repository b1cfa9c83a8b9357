// @ts-check
/** Which part of the world a map of some size shows. */
import { EQUATOR_METERS, project, unproject } from './geo.js';

/** @typedef {import('./geo.js').Place} Place @typedef {import('./geo.js').Point} Point */

const LEAST_SCALE = 400;
const MOST_SCALE = 2 ** 29;
/** "Show all" shows at least so much, for a single drone. */
const LEAST_METERS = 200;
const MARGIN_PIXELS = 56;
/** As near as choosing a drone comes, at least. */
const NEAR_METERS_PER_PIXEL = 0.5;

export class View {
  width = 1;
  height = 1;
  /** In the square of the projection. @type {Point} */
  center = project({ latitude: 47, longitude: 8 });
  /** Pixels that are as long as the side of that square. */
  scale = 1000;

  /** @param {Place} place @returns {Point} */
  toPixels(place) {
    const { x, y } = project(place);
    return {
      x: (x - this.center.x) * this.scale + this.width / 2,
      y: (y - this.center.y) * this.scale + this.height / 2,
    };
  }

  /** @param {Point} pixels @returns {Place} */
  toPlace({ x, y }) {
    return unproject({
      x: (x - this.width / 2) / this.scale + this.center.x,
      y: (y - this.height / 2) / this.scale + this.center.y,
    });
  }

  get metersPerPixel() {
    const { latitude } = unproject(this.center);
    return (EQUATOR_METERS * Math.cos((latitude * Math.PI) / 180)) / this.scale;
  }

  /** @param {number} x pixels to the right @param {number} y pixels down */
  pan(x, y) {
    this.center = { x: this.center.x - x / this.scale, y: this.center.y - y / this.scale };
  }

  /** The place under `at` stays there. @param {number} factor @param {Point} [at] */
  zoom(factor, at = { x: this.width / 2, y: this.height / 2 }) {
    const scale = Math.min(MOST_SCALE, Math.max(LEAST_SCALE, this.scale * factor));
    const x = at.x - this.width / 2;
    const y = at.y - this.height / 2;
    this.center = {
      x: this.center.x + x / this.scale - x / scale,
      y: this.center.y + y / this.scale - y / scale,
    };
    this.scale = scale;
  }

  /** In the middle, and near enough to see where it is. @param {Place} place */
  show(place) {
    this.center = project(place);
    this.zoom(Math.max(1, this.metersPerPixel / NEAR_METERS_PER_PIXEL));
  }

  /** @param {readonly Place[]} places */
  fit(places) {
    if (places.length === 0) {
      return;
    }
    const points = places.map(project);
    const [left, right] = extent(points.map((point) => point.x));
    const [top, bottom] = extent(points.map((point) => point.y));
    this.center = { x: (left + right) / 2, y: (top + bottom) / 2 };
    const least = LEAST_METERS / this.metersPerPixel / this.scale;
    const across = (this.width - 2 * MARGIN_PIXELS) / Math.max(right - left, least);
    const down = (this.height - 2 * MARGIN_PIXELS) / Math.max(bottom - top, least);
    this.scale = Math.min(MOST_SCALE, Math.max(LEAST_SCALE, Math.min(across, down)));
  }
}

/** @param {number[]} numbers @returns {[number, number]} */
function extent(numbers) {
  return [Math.min(...numbers), Math.max(...numbers)];
}

/** The largest of 1, 2 and 5 times a power of ten that is not above. @param {number} most */
export function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  const factor = [5, 2, 1].find((one) => one * power <= most) ?? 1;
  return factor * power;
}
