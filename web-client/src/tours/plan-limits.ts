import { isWithin, type AltitudeRange } from '../plan/draft';
import type { Requirements } from './requirements';

export const SEARCH_SECONDS: AltitudeRange = { lowest: 0.1, highest: 60 };
export const POOL_DRONES: AltitudeRange = { lowest: 1, highest: 100 };
export const WIND_SPEEDS: AltitudeRange = { lowest: 0, highest: 100 };
export const DIRECTIONS: AltitudeRange = { lowest: 0, highest: 360 };
export const WINDOW_SECONDS: AltitudeRange = { lowest: 0, highest: 86_400 };

interface PlanOptions {
  seconds: number | null;
  windSpeed: number | null;
  windFrom: number | null;
}

/** The first option of a plan that is invalid, as a sentence like that of the cloud; null: none is. */
export function whyOptionsInvalid({ seconds, windSpeed, windFrom }: PlanOptions): string | null {
  if (!isWithin(SEARCH_SECONDS, seconds)) {
    return 'Search for 0.1 to 60 seconds.';
  }
  if (windSpeed !== null && !isWithin(WIND_SPEEDS, windSpeed)) {
    return 'The wind must be 0 to 100 m/s.';
  }
  if (windFrom !== null && !isWithin(DIRECTIONS, windFrom)) {
    return 'The wind comes from 0 to 360 degrees.';
  }
  return windSpeed !== null && windSpeed > 0 && windFrom === null ? 'Enter where the wind comes from.' : null;
}

interface DroneChoice {
  ofPool: boolean;
  upTo: number | null;
  chosen: readonly string[];
}

/** Why the choice of drones is none yet, as a sentence; null: it is one. */
export function whyNoDrones({ ofPool, upTo, chosen }: DroneChoice): string | null {
  if (ofPool) {
    return Number.isInteger(upTo) && isWithin(POOL_DRONES, upTo)
      ? null
      : 'Enter how many drones of the pool may fly, 1 to 100.';
  }
  return chosen.length === 0 ? 'Choose drones first.' : null;
}

export const OUTPUTS: AltitudeRange = { lowest: 1, highest: 32 };
export const PULSES: AltitudeRange = { lowest: 500, highest: 2500 };
export const SENSOR_SECONDS: AltitudeRange = { lowest: 1, highest: 3600 };

function whyTasksInvalid({ servo, pulse, sensors }: Requirements, number: number): string | null {
  if ((servo !== null || pulse !== null) && (!isWithin(OUTPUTS, servo) || !isWithin(PULSES, pulse))) {
    return `The servo of waypoint ${number} needs an output from 1 to 32 and 500 to 2500 µs.`;
  }
  return sensors !== null && !isWithin(SENSOR_SECONDS, sensors)
    ? `Sensors are read for 1 to 3600 seconds at waypoint ${number}.`
    : null;
}

/** The first requirement of a waypoint that is invalid, as a sentence; null: none is. */
export function whyRequirementsInvalid(requirements: Requirements, number: number): string | null {
  const { opens, closes } = requirements;
  if (
    (opens !== null && !isWithin(WINDOW_SECONDS, opens)) ||
    (closes !== null && !isWithin(WINDOW_SECONDS, closes))
  ) {
    return `The times of waypoint ${number} must be 0 to 86400 seconds after the start.`;
  }
  return closes !== null && closes < (opens ?? 0)
    ? `Waypoint ${number} ends before it begins.`
    : whyTasksInvalid(requirements, number);
}
