import { describe, expect, it } from 'vitest';
import { aDrone } from '../testing';
import { axesOfKeys, drives, NEUTRAL, paceOf, sum, velocityOf, velocityText } from './axes';

describe('axesOfKeys', () => {
  it('drives what stands on the ground like a car, by letters and arrows alike', () => {
    expect(axesOfKeys(new Set(['KeyW', 'KeyA']), true)).toEqual({ forward: 1, right: 0, up: 0, turn: -1 });
    expect(axesOfKeys(new Set(['ArrowUp', 'ArrowLeft']), true)).toEqual({
      forward: 1,
      right: 0,
      up: 0,
      turn: -1,
    });
  });

  it('moves what flies by letters, and lifts and turns it by arrows', () => {
    expect(axesOfKeys(new Set(['KeyD', 'ArrowDown', 'ArrowRight']), false)).toEqual({
      forward: 0,
      right: 1,
      up: -1,
      turn: 1,
    });
  });

  it('holds nothing by other keys, and the middle by two against each other', () => {
    expect(axesOfKeys(new Set(['KeyQ']), true)).toBeNull();
    expect(axesOfKeys(new Set(['KeyW', 'KeyS']), true)).toEqual(NEUTRAL);
  });
});

describe('velocityOf', () => {
  it('counts downwards, and goes across no faster than ahead', () => {
    const velocity = velocityOf({ forward: 1, right: 1, up: 0.5, turn: -1 }, paceOf(4, false));
    expect(Math.hypot(velocity.forward, velocity.right)).toBeCloseTo(4, 2);
    expect(velocity.down).toBe(-1);
    expect(velocity.turn).toBe(-45);
    expect(velocity.frame).toBe('vehicle');
  });

  it('has one zero', () => {
    expect(Object.is(velocityOf({ ...NEUTRAL, forward: -0 }, paceOf(1, true)).down, 0)).toBe(true);
  });

  it('lets two hands pull no harder than one can', () => {
    const input = { ...NEUTRAL, forward: 0.8 };
    expect(sum([input, input]).forward).toBe(1);
  });
});

describe('words', () => {
  it('say which way it goes', () => {
    const pace = paceOf(1, false);
    expect(velocityText(velocityOf({ forward: -0.5, right: 0, up: 1, turn: 1 }, pace))).toBe(
      '0.5 m/s back, 1.0 m/s up, turning right',
    );
    expect(velocityText(velocityOf(NEUTRAL, pace))).toBe('standing still');
  });

  it('take a robot of an unknown kind for one that drives', () => {
    expect(drives(aDrone({ kind: 'rover' }))).toBe(true);
    expect(drives(aDrone({ kind: 'unknown', modes: [] }))).toBe(true);
    expect(drives(aDrone())).toBe(false);
  });
});
