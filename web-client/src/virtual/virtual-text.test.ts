import { describe, expect, it } from 'vitest';
import type { VirtualDrone, VirtualRun } from '../api/virtual';
import { liveText, shareText, startText, stateText, toneOf, whyNotShared } from './virtual-text';

const RUN: VirtualRun = {
  state: 'flying',
  sentence: 'The drone flies the mission.',
  queue: null,
  flown: 1,
  total: 4,
  onCloudLoss: 'continue',
  why: 'A drone was chosen.',
  drones: 1,
  drone: null,
  detail: null,
  shares: [],
  unfit: [],
  changedAt: '2026-05-04T10:00:00Z',
};

function virtual(part: Partial<VirtualDrone>): VirtualDrone {
  const no = { allowed: false, why: null, mode: null };
  return {
    id: 'v1',
    name: 'Survey',
    owner: 'ann',
    needs: { kind: null, capabilities: [], enduranceMinutes: null, area: null },
    items: null,
    upTo: null,
    run: null,
    live: null,
    actions: { plan: no, start: no, stop: no, resume: no, remove: no },
    ...part,
  };
}

describe('the text of a virtual drone', () => {
  it('shows what is there before it was started', () => {
    expect(stateText(virtual({}))).toBe('no mission yet');
    expect(stateText(virtual({ items: [] }))).toBe('planned');
  });

  it('shows the place in the queue', () => {
    const run: VirtualRun = { ...RUN, state: 'queued', queue: { position: 2, length: 3 } };
    expect(stateText(virtual({ run }))).toBe('waiting, 2 of 3 in the queue');
  });

  it('shows how far it is', () => {
    expect(stateText(virtual({ run: RUN }))).toBe('flying, 1 of 4 waypoints');
    expect(toneOf(virtual({ run: RUN }))).toBe('good');
    expect(toneOf(virtual({ run: { ...RUN, state: 'suspended' } }))).toBe('look');
  });

  it('shows how many share it, and each share', () => {
    const share = { state: 'flying' as const, flown: 1, total: 3 };
    const rest = { sentence: 'It flies.', why: null, drone: null, detail: null, live: null };
    const shares = [
      { ...share, ...rest },
      { ...share, ...rest, state: 'queued' as const, flown: 0 },
    ];
    expect(stateText(virtual({ run: { ...RUN, shares, drones: 1 } }))).toBe(
      'flying, 1 of 4 waypoints, 1 drone',
    );
    expect(shares.map((one, index) => shareText(one, index))).toEqual([
      'Share 1: flying, 1 of 3 waypoints',
      'Share 2: waiting, 0 of 3 waypoints',
    ]);
  });

  it('says how many take off, and how many may', () => {
    expect(startText({ upTo: null })).toBe('A free drone of the pool arms and takes off at once.');
    expect(startText({ upTo: 3 })).toBe('Up to 3 free drones of the pool arm and take off at once.');
    expect([1, 8].map(whyNotShared)).toEqual([null, null]);
    expect([0, 9, 1.5, null].map(whyNotShared)).toEqual(Array(4).fill('Drones: 1 to 8.'));
  });

  it('shows of the drone that serves only what is known', () => {
    const live: VirtualDrone['live'] = {
      link: 'suspect',
      kind: 'multicopter',
      armed: true,
      flight: 'inAir',
      position: null,
      motion: null,
      battery: 87,
    };
    expect(liveText(virtual({ live }))).toBe('contact suspect, battery 87 %');
    expect(liveText(virtual({}))).toBe('');
  });
});
