import { describe, expect, it } from 'vitest';
import type { Drone } from '../api/types';
import { aDrone } from '../testing';
import { LinkHistory } from './link-history';

function withLoss(lossShort: number | null, state: Drone['link']['state'] = 'live'): Drone {
  const { link } = aDrone();
  const quality = { lossLong: null, rttMs: null, rttLongMs: null, jitterMs: null, jitterLongMs: null };
  return aDrone({ link: { ...link, state, quality: { ...quality, lossShort } } });
}

describe('the history of a link', () => {
  let second = 0;
  const history = (): LinkHistory => {
    second = 0;
    return new LinkHistory(() => second * 1000);
  };

  it('is looked at every two seconds, however often the drone reports', () => {
    const links = history();
    for (; second < 10; second += 0.1) {
      links.add(withLoss(0.1));
    }
    expect(links.of('d1').length).toBeLessThanOrEqual(5);
    expect(links.of('d1').at(-1)?.received).toBeCloseTo(0.9);
  });

  it('goes back five minutes', () => {
    const links = history();
    for (; second <= 1000; second += 2) {
      links.add(withLoss(0));
    }
    expect(links.of('d1')).toHaveLength(151);
  });

  it('shows at once that a link is lost, once', () => {
    const links = history();
    links.add(withLoss(0));
    second = 1;
    links.add(withLoss(0, 'lost'));
    second = 1.5;
    links.add(withLoss(0, 'lost'));
    expect(links.of('d1').map((sample) => sample.received)).toEqual([1, 0]);
  });

  it('is broken where nothing came, and knows nothing of what numbers no messages', () => {
    const links = history();
    links.add(withLoss(0));
    second = 60;
    links.add(withLoss(0));
    links.add(withLoss(null));
    expect(links.of('d1').map((sample) => sample.begins)).toEqual([true, true]);
    links.remove('d1');
    expect(links.of('d1')).toEqual([]);
  });
});
