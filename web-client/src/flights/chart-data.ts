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
    const least = field?.least[index] ?? null;
    const most = field?.most[index] ?? null;
    put(data, at, least);
    if (most !== least) {
      put(data, at + series.slotSeconds / 2, most);
    }
  });
  return data;
}

function put(data: ChartData, time: number, value: number | null): void {
  // Times must rise.
  const last = data.times.at(-1) ?? -Infinity;
  data.times.push(Math.max(time, last + 1e-6));
  data.values.push(value);
}

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
  missionItem: 'Mission item',
  latitude: 'Latitude',
  longitude: 'Longitude',
};

/** What can be drawn, by name. */
export const CHART_FIELDS = Object.keys(TITLES);
export const USUAL_FIELDS = ['altitudeAboveHome', 'groundSpeed', 'batteryPercent', 'lossShort'];

export function chartTitle(name: string, unit: string): string {
  const title = TITLES[name] ?? name;
  return unit === '' ? title : `${title}, ${unit}`;
}
