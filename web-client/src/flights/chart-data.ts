import type { Series } from '../api/flights';

/** Times in seconds, and for each of them a value; null breaks the line. */
export interface ChartData {
  times: number[];
  values: (number | null)[];
}

/** Less than this apart is one line, however fine the slots are: at rest a state is kept every five seconds. */
const SHORTEST_GAP_SECONDS = 12;

/**
 * Each slot becomes two points, its least and its greatest value, so that every peak is drawn; a stretch without any
 * becomes a gap.
 */
export function chartData(series: Series, name: string): ChartData {
  const field = series.fields.find((one) => one.name === name);
  const data: ChartData = { times: [], values: [] };
  const longest = Math.max(SHORTEST_GAP_SECONDS, series.slotSeconds * 3);
  series.times.forEach((time, index) => {
    const at = Date.parse(time) / 1000;
    const last = data.times.at(-1);
    if (last !== undefined && at - last > longest) {
      put(data, last + 0.001, null);
    }
    const least = shown(name, field?.least[index] ?? null);
    const most = shown(name, field?.most[index] ?? null);
    const [first, second] = inOrder(data.values.at(-1) ?? null, least, most);
    put(data, at, first);
    if (second !== first) {
      put(data, at + series.slotSeconds / 2, second);
    }
  });
  return data;
}

/** Shares are drawn in percent. */
function shown(name: string, value: number | null): number | null {
  return value !== null && SHARES.has(name) ? value * 100 : value;
}

/** The value nearer to the previous one is drawn first, so that a steady descent has no teeth. */
function inOrder(
  before: number | null,
  least: number | null,
  most: number | null,
): [number | null, number | null] {
  const falling =
    before !== null && least !== null && most !== null && Math.abs(most - before) < Math.abs(least - before);
  return falling ? [most, least] : [least, most];
}

function put(data: ChartData, time: number, value: number | null): void {
  // Times must rise.
  const last = data.times.at(-1) ?? -Infinity;
  data.times.push(Math.max(time, last + 1e-6));
  data.values.push(value);
}

const SHARES = new Set(['lossShort', 'lossLong']);

const TITLES: Record<string, string> = {
  altitudeAboveHome: 'Altitude above home',
  altitudeAmsl: 'Altitude above sea level',
  groundSpeed: 'Ground speed',
  airSpeed: 'Air speed',
  climbRate: 'Climb',
  heading: 'Heading',
  roll: 'Roll',
  pitch: 'Pitch',
  yaw: 'Yaw',
  batteryPercent: 'Battery',
  batteryVolts: 'Battery voltage',
  batteryAmps: 'Battery current',
  satellites: 'Satellites',
  hdop: 'Position uncertainty (HDOP)',
  lossShort: 'Messages lost (5 s)',
  lossLong: 'Messages lost (60 s)',
  roundTrip: 'Round trip',
  jitter: 'Jitter (5 s)',
  jitterLong: 'Jitter (60 s)',
  missionItem: 'Mission item',
  latitude: 'Latitude',
  longitude: 'Longitude',
};

/** The names of all fields that can be drawn. */
export const CHART_FIELDS = Object.keys(TITLES);
export const USUAL_FIELDS = ['altitudeAboveHome', 'groundSpeed', 'batteryPercent', 'lossShort'];

export function chartTitle(name: string, unit: string): string {
  const title = TITLES[name] ?? name;
  const shownUnit = SHARES.has(name) ? '%' : unit;
  return shownUnit === '' ? title : `${title}, ${shownUnit}`;
}
