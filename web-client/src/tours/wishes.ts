import { isWithin, type AltitudeRange } from '../plan/draft';
import type { Demand } from './demand';

export const SEARCH_SECONDS: AltitudeRange = { lowest: 0.1, highest: 60 };
export const WIND_SPEEDS: AltitudeRange = { lowest: 0, highest: 100 };
export const DIRECTIONS: AltitudeRange = { lowest: 0, highest: 360 };
export const WINDOW_SECONDS: AltitudeRange = { lowest: 0, highest: 86_400 };

interface Wishes {
  seconds: number | null;
  windSpeed: number | null;
  windFrom: number | null;
}

/** What is wrong with the wishes for a plan, as the cloud would say; null: nothing is. */
export function whyNotWished({ seconds, windSpeed, windFrom }: Wishes): string | null {
  if (!isWithin(SEARCH_SECONDS, seconds)) {
    return 'Search for 0.1 to 60 seconds.';
  }
  if (windSpeed !== null && !isWithin(WIND_SPEEDS, windSpeed)) {
    return 'The wind must be 0 to 100 m/s.';
  }
  if (windFrom !== null && !isWithin(DIRECTIONS, windFrom)) {
    return 'The wind comes from 0 to 360 degrees.';
  }
  return windSpeed !== null && windSpeed > 0 && windFrom === null ? 'Say where the wind comes from.' : null;
}

export const OUTPUTS: AltitudeRange = { lowest: 1, highest: 32 };
export const PULSES: AltitudeRange = { lowest: 500, highest: 2500 };
export const SENSOR_SECONDS: AltitudeRange = { lowest: 1, highest: 3600 };

function whyNotDone({ servo, pulse, sensors }: Demand, number: number): string | null {
  if ((servo !== null || pulse !== null) && (!isWithin(OUTPUTS, servo) || !isWithin(PULSES, pulse))) {
    return `The servo of waypoint ${number} needs an output from 1 to 32 and 500 to 2500 µs.`;
  }
  return sensors !== null && !isWithin(SENSOR_SECONDS, sensors)
    ? `Sensors are read for 1 to 3600 seconds at waypoint ${number}.`
    : null;
}

/** The same of what one waypoint asks for. */
export function whyNotAsked(demand: Demand, number: number): string | null {
  const { opens, closes } = demand;
  if (
    (opens !== null && !isWithin(WINDOW_SECONDS, opens)) ||
    (closes !== null && !isWithin(WINDOW_SECONDS, closes))
  ) {
    return `The times of waypoint ${number} must be 0 to 86400 seconds after the start.`;
  }
  return closes !== null && closes < (opens ?? 0)
    ? `Waypoint ${number} ends before it begins.`
    : whyNotDone(demand, number);
}
