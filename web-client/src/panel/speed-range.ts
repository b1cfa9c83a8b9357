import type { Drone } from '../api/types';

/** Speeds that a kind of vehicle is told to go on at, in m/s; the cloud takes the same. */
export interface SpeedBounds {
  lowest: number;
  highest: number;
  /** Filled in at first. */
  usual: number;
}

const WINGS: SpeedBounds = { lowest: 3, highest: 100, usual: 15 };
const ROTORS: SpeedBounds = { lowest: 0.2, highest: 30, usual: 5 };
const WHEELS: SpeedBounds = { lowest: 0.1, highest: 30, usual: 2 };
const ANY: SpeedBounds = { lowest: 0.1, highest: 100, usual: 5 };

export function speedBounds(kind: Drone['kind']): SpeedBounds {
  switch (kind) {
    case 'fixedWing':
      return WINGS;
    case 'multicopter':
    case 'helicopter':
    case 'submarine':
      return ROTORS;
    case 'rover':
    case 'boat':
      return WHEELS;
    default:
      return ANY;
  }
}

/** The reason for which that speed is none for such a vehicle, or null. */
export function speedProblem({ lowest, highest }: SpeedBounds, speed: number | null): string | null {
  return speed !== null && speed >= lowest && speed <= highest
    ? null
    : `The speed must be ${lowest} to ${highest} m/s.`;
}
