import { describe, expect, it } from 'vitest';
import type { Attempt } from '../state/commands.svelte';
import { aDrone } from '../testing';
import { whyNot, attemptText } from './action';
import { missionRows, missionSummary, whyNoStart } from './mission-text';

const attempt = (change: Partial<Attempt>): Attempt => ({
  id: 'c1',
  drone: 'd1',
  type: 'arm',
  phase: 'done',
  outcome: null,
  problem: null,
  field: null,
  progress: null,
  ...change,
});

describe('controls', () => {
  it('say why they cannot be used', () => {
    const drone = aDrone();
    expect(whyNot(drone, 'arm', null)).toBeNull();
    expect(whyNot(drone, 'takeOff', null)).toBe('Arm first.');
    expect(whyNot(drone, 'arm', 'No connection to the cloud.')).toBe('No connection to the cloud.');
    expect(whyNot(drone, 'land', null)).toBe('This vehicle cannot do that.');
  });

  it('show the refusal of the vehicle in its own words', () => {
    const outcome = {
      result: 'refused',
      by: 'vehicle',
      reason: 'PreArm: GPS not ready',
      code: 'vehicle-failed',
    } as const;
    expect(attemptText(attempt({ outcome }))).toEqual({
      tone: 'bad',
      words: 'Refused by the vehicle. PreArm: GPS not ready',
    });
  });

  it('show how far an upload is', () => {
    const text = attemptText(attempt({ phase: 'accepted', progress: { done: 2, total: 5 } }));
    expect(text).toEqual({ tone: 'busy', words: 'Accepted 2 of 5, under way…' });
  });

  it('say that a flight has begun, not that it has ended', () => {
    const outcome = { result: 'succeeded', by: 'vehicle', reason: null, code: null } as const;
    expect(attemptText(attempt({ type: 'returnToLaunch', outcome })).words).toBe('Under way');
    expect(attemptText(attempt({ type: 'arm', outcome })).words).toBe('Done');
  });

  it('never call a command without known outcome a success', () => {
    expect(attemptText(attempt({ outcome: null })).tone).toBe('bad');
    expect(
      attemptText(
        attempt({ outcome: { result: 'timedOut', by: null, reason: null, code: 'command-timed-out' } }),
      ).tone,
    ).toBe('bad');
  });
});

describe('mission of the vehicle', () => {
  const mission = {
    items: [
      { type: 'takeOff', altitude: 20 },
      { type: 'waypoint', latitude: 1, longitude: 2, altitude: 30, altitudeReference: 'home' },
      { type: 'returnToLaunch' },
    ],
    current: 1,
    reached: [0],
    total: 3,
    running: true,
    state: null,
    notice: null,
    hash: null,
  } satisfies Parameters<typeof missionSummary>[0];

  it('reads as lines with what is reached and what comes now', () => {
    expect(missionRows(mission).map(({ words, state }) => [words, state])).toEqual([
      ['Take off to 20 m', 'reached'],
      ['Waypoint at 30 m', 'current'],
      ['Return to launch', 'ahead'],
    ]);
  });

  it('sums up running, stopped, finished, none and unknown', () => {
    expect(missionSummary(mission)).toBe('Mission is running: item 2 of 3, 1 reached.');
    expect(missionSummary({ ...mission, running: false })).toBe(
      'Mission is not running: 1 of 3 items reached.',
    );
    expect(missionSummary({ ...mission, reached: [0, 1, 2] })).toBe('Mission complete: 3 items.');
    expect(missionSummary({ ...mission, items: [], total: 0 })).toBe('No mission on the vehicle.');
    expect(missionSummary(null)).toContain('unknown');
  });

  it('believes the vehicle when it says that the mission is complete or paused', () => {
    expect(missionSummary({ ...mission, running: false, state: 'complete' })).toBe(
      'Mission complete: 3 items.',
    );
    expect(missionSummary({ ...mission, running: false, state: 'paused' })).toBe(
      'Mission is paused: 1 of 3 items reached.',
    );
    expect(missionSummary({ ...mission, reached: [0, 1, 2], state: 'running' })).toBe(
      'Mission is running: item 2 of 3, 3 reached.',
    );
  });

  it('need not be started while it is flown', () => {
    expect(whyNoStart(aDrone({ mission, flight: 'inAir' }))).toBe('It is running.');
    expect(whyNoStart(aDrone({ mission, flight: 'onGround' }))).toBeNull();
    expect(whyNoStart(aDrone({ mission: { ...mission, running: false }, flight: 'inAir' }))).toBeNull();
    const complete = { ...mission, reached: [0, 1, 2] };
    expect(whyNoStart(aDrone({ mission: complete, flight: 'inAir' }))).toBeNull();
  });
});
