import type { Drone, Velocity } from '../api/types';

/** The deflection of each control, −1 to 1: ahead, to the right, upwards, and turning clockwise. */
export interface Axes {
  forward: number;
  right: number;
  up: number;
  turn: number;
}

/** Speeds at full deflection: metres and degrees a second. */
export interface Pace {
  speed: number;
  climb: number;
  turn: number;
}

export interface SpeedRange {
  lowest: number;
  highest: number;
  usual: number;
  step: number;
}

export const NEUTRAL: Axes = { forward: 0, right: 0, up: 0, turn: 0 };

const GROUND_RANGE: SpeedRange = { lowest: 0.1, highest: 1, usual: 0.3, step: 0.1 };
const AIR_RANGE: SpeedRange = { lowest: 0.5, highest: 5, usual: 1, step: 0.5 };
const GROUND_TURN = 60;
const AIR_TURN = 45;
const FASTEST_CLIMB = 2;

type AxisInput = [keyof Axes, number];

/** The places of keys, whatever letters a keyboard has there. */
const GROUND_KEYS: Readonly<Record<string, AxisInput>> = {
  KeyW: ['forward', 1],
  KeyS: ['forward', -1],
  KeyA: ['turn', -1],
  KeyD: ['turn', 1],
  ArrowUp: ['forward', 1],
  ArrowDown: ['forward', -1],
  ArrowLeft: ['turn', -1],
  ArrowRight: ['turn', 1],
};

const AIR_KEYS: Readonly<Record<string, AxisInput>> = {
  KeyW: ['forward', 1],
  KeyS: ['forward', -1],
  KeyA: ['right', -1],
  KeyD: ['right', 1],
  ArrowUp: ['up', 1],
  ArrowDown: ['up', -1],
  ArrowLeft: ['turn', -1],
  ArrowRight: ['turn', 1],
};

/** It drives, and is steered like a car; what neither drives nor can take off is taken for something that drives. */
export function drives(drone: Drone): boolean {
  return ['rover', 'boat'].includes(drone.kind) || (drone.kind === 'unknown' && drone.modes.length === 0);
}

export function rangeOf(ground: boolean): SpeedRange {
  return ground ? GROUND_RANGE : AIR_RANGE;
}

export function paceOf(speed: number, ground: boolean): Pace {
  return { speed, climb: Math.min(speed, FASTEST_CLIMB), turn: ground ? GROUND_TURN : AIR_TURN };
}

export function isSteeringKey(code: string, ground: boolean): boolean {
  return code in (ground ? GROUND_KEYS : AIR_KEYS);
}

/** The axes of all keys that are down; null when none of them steers. */
export function axesOfKeys(down: ReadonlySet<string>, ground: boolean): Axes | null {
  const keys = ground ? GROUND_KEYS : AIR_KEYS;
  const inputs = [...down].map((code) => keys[code]).filter((input) => input !== undefined);
  return inputs.length === 0 ? null : sum(inputs.map(([axis, way]) => ({ ...NEUTRAL, [axis]: way })));
}

/** Adds the inputs of several sources, each axis within its range. */
export function sum(inputs: Iterable<Axes>): Axes {
  const all = { ...NEUTRAL };
  for (const input of inputs) {
    for (const axis of Object.keys(all) as (keyof Axes)[]) {
      all[axis] = bounded(all[axis] + input[axis]);
    }
  }
  return all;
}

function bounded(value: number): number {
  return Math.max(-1, Math.min(1, value));
}

/** Speeds from the nose of the vehicle; across, it is no faster than straight on. */
export function velocityOf(axes: Axes, pace: Pace): Velocity {
  const far = Math.max(1, Math.hypot(axes.forward, axes.right));
  return {
    frame: 'vehicle',
    forward: rounded((axes.forward / far) * pace.speed),
    right: rounded((axes.right / far) * pace.speed),
    down: rounded(-axes.up * pace.climb),
    turn: rounded(axes.turn * pace.turn),
  };
}

function rounded(value: number): number {
  // There is one zero.
  return Math.round(value * 1000) / 1000 + 0;
}

/** "0.3 m/s ahead, turning right", for people. */
export function velocityText(velocity: Velocity): string {
  const parts = [
    speedText(velocity.forward, 'ahead', 'back'),
    speedText(velocity.right, 'right', 'left'),
    speedText(-velocity.down, 'up', 'down'),
    velocity.turn === 0 ? '' : `turning ${velocity.turn > 0 ? 'right' : 'left'}`,
  ].filter((part) => part !== '');
  return parts.length === 0 ? 'standing still' : parts.join(', ');
}

function speedText(speed: number, positive: string, negative: string): string {
  return speed === 0 ? '' : `${Math.abs(speed).toFixed(1)} m/s ${speed > 0 ? positive : negative}`;
}
