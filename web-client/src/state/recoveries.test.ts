import { beforeEach, describe, expect, it } from 'vitest';
import { Problem } from '../api/problem';
import { RecoveryCalls } from '../api/recoveries';
import { recoveryFeatures } from '../recovery/recovery-features';
import { legText, plannedText, recoveryText } from '../recovery/recovery-text';
import { aRecovery, aRecoveryPreview } from '../recovery/testing';
import { operationsBy } from '../testing';
import { Recoveries } from './recoveries.svelte';

let asked: [string, unknown][];
let answers: Record<string, () => unknown>;
let recoveries: Recoveries;

beforeEach(() => {
  asked = [];
  answers = {
    previewRecovery: () => aRecoveryPreview(),
    beginRecovery: () => aRecovery(),
    cancelRecovery: () => aRecovery({ state: 'givingBack' }),
  };
  const calls = operationsBy((operation, order) => {
    asked.push([operation, order]);
    return Promise.resolve(answers[operation]?.());
  });
  recoveries = new Recoveries(new RecoveryCalls(calls));
});

describe('drones that come home together', () => {
  it('commands nothing before the preview is confirmed, and then what was shown', async () => {
    await recoveries.look('return');
    expect(recoveries.preview?.drones).toHaveLength(1);
    expect(asked).toEqual([['previewRecovery', { manner: 'return' }]]);
    await recoveries.confirm();
    expect(asked.at(-1)).toEqual(['beginRecovery', { manner: 'return', previewed: ['d1'] }]);
    expect(recoveries.preview).toBeNull();
    expect(recoveries.shown('ann')).toHaveLength(1);
    expect(recoveries.shown('bob')).toHaveLength(0);
  });

  it('says why they do not fit, and confirms nothing then', async () => {
    answers.previewRecovery = () => {
      throw new Problem({ status: 409, detail: '5 of 9 drones fit.' });
    };
    await recoveries.look('return');
    expect(recoveries.problem).toContain('5 of 9 drones fit');
    await recoveries.confirm();
    expect(asked).toHaveLength(1);
  });

  it('shows a new preview where others would come by now', async () => {
    await recoveries.look('land');
    const [one] = aRecoveryPreview().drones;
    answers.previewRecovery = () => ({ ...aRecoveryPreview(), drones: [one, { ...one, drone: 'd2' }] });
    answers.beginRecovery = () => {
      throw new Problem({
        status: 409,
        code: 'recovery-changed',
        detail: 'More drones would come: Kestrel.',
      });
    };
    await recoveries.confirm();
    expect(recoveries.problem).toContain('More drones would come: Kestrel.');
    expect(recoveries.preview?.drones).toHaveLength(2);
    expect(recoveries.shown('ann')).toHaveLength(0);
    answers.beginRecovery = () => aRecovery();
    await recoveries.confirm();
    expect(asked.at(-1)).toEqual(['beginRecovery', { manner: 'land', previewed: ['d1', 'd2'] }]);
    expect(recoveries.problem).toBeNull();
  });

  it('leaves one that is over until it is put aside', () => {
    recoveries.apply(aRecovery({ state: 'over' }));
    expect(recoveries.shown('ann')).toHaveLength(0);
    recoveries.apply(aRecovery());
    recoveries.apply(aRecovery({ state: 'over', end: 'All are down.' }));
    expect(recoveryText(recoveries.shown('ann')[0] ?? aRecovery())).toBe('All are down.');
    recoveries.putAside('c1');
    expect(recoveries.shown('ann')).toHaveLength(0);
  });

  it('tells of each drone what it does, for whom it waits, and what became of it', () => {
    const [leg] = aRecovery().drones;
    expect(leg && legText(leg)).toBe('holds at its height · waits for Kestrel');
    expect(leg && legText({ ...leg, outcome: 'taken', note: 'A pilot flies it.' })).toBe(
      'taken · A pilot flies it.',
    );
    const [one] = aRecoveryPreview().drones;
    expect(one && plannedText(one, 'return')).toContain('at 26 m · down in');
    expect(one && plannedText(one, 'land')).toContain('from 26 m · down in');
    expect(one && plannedText({ ...one, plan: null }, 'return')).toContain('not heard');
  });

  it('draws the way and the spot of each', () => {
    const { features } = recoveryFeatures(aRecoveryPreview());
    expect(features.map((one) => one.geometry.type)).toEqual(['LineString', 'Point']);
    expect(features[1]?.properties).toEqual({ label: '1 · Falcon · 26 m' });
  });
});
