import { describe, expect, it } from 'vitest';
import type { FollowStage } from '../api/follows';
import { aFollow, aFollowNow } from '../testing';
import { AbsenceWatch } from './absence.svelte';
import { cutOffSummary, outageState, silentSeconds } from './outage';

const at = (second: number): string => new Date(Date.UTC(2026, 0, 1, 12, 0, second)).toISOString();
const ms = (second: number): number => Date.parse(at(second));
const tracking = (heard: number, reach: 'speaks' | 'asleep' | 'cut' | 'gone' = 'speaks') =>
  aFollow({ state: 'tracking', since: at(0), now: aFollowNow(at(heard), reach) });

describe('what a drone does while its phone is silent', () => {
  it('counts down to its way home while it follows, and to nothing at any other stage', () => {
    const follow = aFollow({ state: 'tracking' });
    expect(outageState(follow, 12)).toEqual({
      words: 'Copter 1 stands still in the air and waits.',
      homeIn: 48,
    });
    expect(outageState(follow, 60)).toEqual({
      words: 'Copter 1 has waited long enough: by now it flies home and lands there.',
      homeIn: null,
    });
    const others: FollowStage[] = ['allocated', 'starting', 'paused', 'suspended', 'returning', 'over'];
    const texts = others.map((state) => outageState(aFollow({ state }), 12));
    expect(new Set(texts.map(({ words }) => words)).size).toBe(others.length);
    expect(texts.filter(({ homeIn }) => homeIn !== null)).toEqual([]);
  });

  it('is one line, and counts down only where the cloud leads it', () => {
    const follow = aFollow({ state: 'tracking' });
    expect(cutOffSummary(follow, 12, false)).toBe('No network. Copter 1 flies home in 48 s.');
    expect(cutOffSummary(follow, 12, true)).toBe('The cloud does not answer.');
    expect(cutOffSummary(aFollow({ state: 'paused' }), 12, false)).toBe('No network.');
  });

  it('is shown to the station when it counts: not for a position that is a little late', () => {
    expect(silentSeconds(tracking(10), ms(13))).toBeNull();
    expect(silentSeconds(tracking(10), ms(14))).toBe(4);
    expect(silentSeconds(tracking(10, 'gone'), ms(13))).toBe(3);
    expect(silentSeconds(aFollow({ state: 'paused', now: aFollowNow(at(1)) }), ms(30))).toBeNull();
    expect(silentSeconds(aFollow({ state: 'tracking' }), ms(30))).toBeNull();
  });

  it('is not counted from before it followed', () => {
    expect(silentSeconds({ ...tracking(1), since: at(20) }, ms(22))).toBeNull();
  });
});

describe('a phone that is back', () => {
  const away = (from: number, to: number, told: 'asleep' | 'cut' | 'gone' | 'speaks'): AbsenceWatch => {
    const watch = new AbsenceWatch();
    watch.update(tracking(from), ms(from));
    watch.update(tracking(from, told), ms(from + 3));
    watch.update(tracking(to), ms(to));
    return watch;
  };

  it('knows the reason that the cloud reports, and how long the drone stood', () => {
    expect(away(10, 44, 'asleep').last).toEqual({
      why: 'asleep',
      seconds: 34,
      waited: 32,
      from: ms(10),
      until: ms(44),
    });
    expect(away(10, 44, 'cut').last?.why).toBe('cut');
    expect(away(10, 44, 'gone').last?.why).toBe('gone');
    expect(away(10, 12, 'speaks').last).toBeNull();
  });

  it('says that the cloud did not answer when it had a network all the time', () => {
    const watch = away(10, 12, 'speaks');
    watch.suspect('unanswered', ms(15));
    watch.update(tracking(40), ms(40));
    expect(watch.last?.why).toBe('unanswered');
    watch.suspect('cut', ms(45));
    watch.suspect('unanswered', ms(46));
    watch.update(tracking(60), ms(60));
    expect(watch.last?.why).toBe('cut');
  });

  it('believes what it knows itself: that it slept more than that it was cut off', () => {
    const watch = away(10, 12, 'speaks');
    watch.suspect('asleep', ms(12));
    watch.suspect('cut', ms(12));
    watch.update(tracking(12, 'gone'), ms(20));
    watch.update(tracking(40), ms(40));
    expect(watch.last?.why).toBe('asleep');
    watch.update(tracking(50), ms(50));
    expect(watch.last?.why).toBe('cut');
  });

  it('shows of nothing that was before the drone followed, nor when it does not follow any more', () => {
    const watch = new AbsenceWatch();
    watch.update(tracking(10), ms(10));
    watch.update({ ...tracking(40), since: at(39) }, ms(40));
    expect(watch.last).toBeNull();
    watch.update({ ...tracking(80), state: 'returning' }, ms(80));
    expect(watch.last).toBeNull();
  });
});
