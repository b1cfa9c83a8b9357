// @ts-check
/** What a map shows, as elements of SVG; one function for each layer. */
import { svg } from './dom.js';
import { fixed, isAirborne, metersText, placeOf } from './drone.js';
import { EQUATOR_METERS } from './geo.js';
import { roundLength } from './view.js';

/**
 * @typedef {import('./view.js').View} View
 * @typedef {import('./geo.js').Place} Place
 * @typedef {import('./geo.js').Point} Point
 * @typedef {import('./drone.js').Drone} Drone
 */

const GRID_PIXELS = 90;
const SCALE_PIXELS = 110;
const LETTER_PIXELS = 7.4;

/** @param {View} view */
export function grid(view) {
  // By whole degrees of latitude, so that lines do not slide while the map is dragged.
  const latitude = Math.round(view.toPlace({ x: 0, y: view.height / 2 }).latitude);
  const worldMeters = EQUATOR_METERS * Math.cos((latitude * Math.PI) / 180);
  const step = (roundLength((GRID_PIXELS * 2 * worldMeters) / view.scale) / worldMeters) * view.scale;
  let lines = '';
  const left = view.center.x * view.scale - view.width / 2;
  for (let x = Math.ceil(left / step) * step - left; x < view.width; x += step) {
    lines += `M${x.toFixed(1)} 0V${view.height}`;
  }
  const top = view.center.y * view.scale - view.height / 2;
  for (let y = Math.ceil(top / step) * step - top; y < view.height; y += step) {
    lines += `M0 ${y.toFixed(1)}H${view.width}`;
  }
  return [svg('path', { class: 'grid', d: lines })];
}

/** @param {View} view */
export function scaleBar(view) {
  const meters = roundLength(SCALE_PIXELS * view.metersPerPixel);
  const length = meters / view.metersPerPixel;
  const [x, y] = [14, view.height - 16];
  return [
    svg('path', { class: 'scale', d: `M${x} ${y - 6}v6h${length.toFixed(1)}v-6` }),
    svg('text', { class: 'scale-text', x: x + 4, y: y - 10 }, metersText(meters)),
    svg('path', { class: 'scale', d: `M${view.width - 24} 40V16m-5 7 5-8 5 8` }),
    svg('text', { class: 'scale-text', x: view.width - 24, y: 54, 'text-anchor': 'middle' }, 'N'),
  ];
}

/** @param {View} view @param {readonly Place[]} places @param {string} name */
export function line(view, places, name) {
  const points = places.map((place) => view.toPixels(place));
  const d = points
    .map(({ x, y }, index) => `${index === 0 ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`)
    .join('');
  return points.length < 2 ? [] : [svg('path', { class: name, d })];
}

/** @param {View} view @param {Place} place @param {string} name @param {string} text */
export function numbered(view, place, name, text) {
  const { x, y } = view.toPixels(place);
  return svg(
    'g',
    { class: name, transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})` },
    svg('circle', { r: 13 }),
    svg('text', { 'text-anchor': 'middle', y: 4.5 }, text),
  );
}

/** The mission on board: its way, and which places were reached. @param {View} view @param {Drone} drone */
export function boardMission(view, { mission }) {
  const reached = new Set(mission.reached ?? []);
  const waypoints = (mission.items ?? []).flatMap((item, index) =>
    item.waypoint ? [{ ...item.waypoint, index }] : [],
  );
  const dots = waypoints.map((waypoint, index) => {
    const done = reached.has(waypoint.index);
    const next = mission.running && mission.current === waypoint.index;
    const name = done ? 'board reached' : next ? 'board next' : 'board';
    return numbered(view, waypoint, name, done ? '✓' : String(index + 1));
  });
  return [...line(view, waypoints, 'board-way'), ...dots];
}

/** @param {View} view @param {Place} home */
export function homeMark(view, home) {
  const { x, y } = view.toPixels(home);
  return svg(
    'g',
    { class: 'home', transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})` },
    svg('circle', { r: 10 }),
    svg('path', { d: 'M-5 0 0-5 5 0M-3.5-1v5h7v-5' }),
    svg('title', {}, 'Home'),
  );
}

/** @param {View} view @param {Place} place */
export function targetMark(view, place) {
  const { x, y } = view.toPixels(place);
  return svg(
    'g',
    { class: 'target', transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})` },
    svg('circle', { r: 12 }),
    svg('path', { d: 'M-18 0h12M6 0h12M0-18v12M0 6v12' }),
    svg('title', {}, 'Place to fly to'),
  );
}

/** @param {View} view */
export function crosshair(view) {
  const [x, y] = [view.width / 2, view.height / 2];
  return [svg('path', { class: 'crosshair', d: `M${x - 14} ${y}h10m8 0h10M${x} ${y - 14}v10m0 8v10` })];
}

/**
 * All drones with their labels, the chosen one on top; no label covers one of the places.
 * @param {View} view @param {readonly Drone[]} drones @param {string | null} chosen @param {readonly Place[]} places
 */
export function droneMarks(view, drones, chosen, places) {
  const placed = drones.flatMap((drone) => {
    const place = placeOf(drone);
    return place === null ? [] : [{ drone, point: view.toPixels(place) }];
  });
  placed.sort((one, other) => Number(one.drone.id === chosen) - Number(other.drone.id === chosen));
  const points = [...placed.map(({ point }) => point), ...places.map((place) => view.toPixels(place))];
  const taken = [...scaleBoxes(view), ...points.map(({ x, y }) => box(x - 15, y - 15, 30, 30))];
  return placed
    .reverse()
    .map(({ drone, point }) => {
      const isChosen = drone.id === chosen;
      return svg(
        'g',
        { class: `drone ${markOf(drone)}${isChosen ? ' chosen' : ''}`, 'data-drone': drone.id },
        ...symbol(drone, point, isChosen),
        ...label(view, drone, point, taken),
      );
    })
    .reverse();
}

/** Where the scale and the north arrow are. @param {View} view */
function scaleBoxes(view) {
  return [box(0, view.height - 46, 140, 46), box(view.width - 44, 0, 44, 60)];
}

/** @param {Drone} drone */
function markOf(drone) {
  if (drone.link.state === 'lost' || drone.link.state === 'ended') {
    return drone.armed ? 'lost' : 'lost unarmed';
  }
  return drone.link.state === 'suspect' ? 'silent' : isAirborne(drone) ? 'airborne' : 'ground';
}

/** @param {Drone} drone @param {Point} point @param {boolean} chosen */
function symbol(drone, { x, y }, chosen) {
  const heading = drone.motion?.heading ?? null;
  const lost = markOf(drone).startsWith('lost');
  const turn = heading === null ? '' : ` rotate(${heading.toFixed(0)})`;
  const shape = heading === null ? 'M-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0' : 'M0-8.5 6 7.5 0 4.5-6 7.5Z';
  return [
    ...(chosen ? [svg('circle', { class: 'halo', cx: x.toFixed(1), cy: y.toFixed(1), r: 19 })] : []),
    svg('circle', { class: 'ring', cx: x.toFixed(1), cy: y.toFixed(1), r: 13 }),
    svg('path', { class: 'arrow', d: shape, transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})${turn}` }),
    ...(lost ? [svg('path', { class: 'cross', d: `M${x - 9} ${y - 9}l18 18m0-18l-18 18` })] : []),
  ];
}

/**
 * Name and height where nothing else is; where there is no room, only the symbol.
 * @param {View} view @param {Drone} drone @param {Point} point @param {Box[]} taken
 */
function label(view, drone, { x, y }, taken) {
  const height = drone.position?.altitudeAboveHome ?? null;
  const text = drone.link.state === 'lost' ? `${drone.name} · lost` : `${drone.name} · ${fixed(height)} m`;
  const width = text.length * LETTER_PIXELS + 12;
  const across = Math.max(0, Math.min(view.width - width, x - width / 2));
  const free = [
    box(x + 22, y - 11, width, 22),
    box(x - 22 - width, y - 11, width, 22),
    box(across, y - 44, width, 22),
    box(across, y + 22, width, 22),
  ].find((one) => one.x >= 0 && one.x + width <= view.width && taken.every((other) => !overlap(one, other)));
  if (free === undefined) {
    return [];
  }
  taken.push(free);
  return [
    svg('rect', { class: 'pill', x: free.x, y: free.y, width: free.width, height: free.height, rx: 6 }),
    svg(
      'text',
      { class: 'label', x: free.x + free.width / 2, y: free.y + 15.5, 'text-anchor': 'middle' },
      text,
    ),
  ];
}

/** @typedef {{ x: number, y: number, width: number, height: number }} Box */
/** @param {number} x @param {number} y @param {number} width @param {number} height @returns {Box} */
function box(x, y, width, height) {
  return { x, y, width, height };
}

/** @param {Box} one @param {Box} other */
function overlap(one, other) {
  return (
    one.x < other.x + other.width &&
    other.x < one.x + one.width &&
    one.y < other.y + other.height &&
    other.y < one.y + one.height
  );
}
