import { describe, expect, it } from 'vitest';
import type { LinkQuality } from '../api/types';
import { lossTone, linkQualityText, linkTrendText, trendTone } from './link-text';

const UNKNOWN_QUALITY: LinkQuality = {
  lossShort: null,
  lossLong: null,
  rttMs: null,
  rttLongMs: null,
  jitterMs: null,
  jitterLongMs: null,
};

describe('the link line', () => {
  it('says what was lost, how long an answer takes and how unevenly messages come', () => {
    const quality = { ...UNKNOWN_QUALITY, lossShort: 0.25, lossLong: 0.012, rttMs: 41.6, jitterMs: 7.4 };
    expect(linkQualityText(quality)).toBe(
      'Link: 25 % lost now, 1.2 % in a minute · round trip 42 ms · jitter 7 ms',
    );
  });

  it('shows what is unknown as unknown', () => {
    expect(linkQualityText(undefined)).toBe('Link quality —');
    expect(linkQualityText({ ...UNKNOWN_QUALITY, lossShort: 0 })).toBe(
      'Link: 0 % lost now, — in a minute · round trip — · jitter —',
    );
  });

  it('turns amber when a pilot should know', () => {
    expect(lossTone({ ...UNKNOWN_QUALITY, lossShort: 0.06, lossLong: 0 })).toBe('amber');
    expect(lossTone({ ...UNKNOWN_QUALITY, lossShort: 0.01, lossLong: 0 })).toBe('neutral');
    expect(lossTone(undefined)).toBe('neutral');
  });

  it('says where the link goes only when that is not as usual', () => {
    const sentence = 'Its link gets worse.';
    expect(linkTrendText(undefined)).toBeNull();
    expect(linkTrendText({ state: 'steady', secondsLeft: null, sentence })).toBeNull();
    expect(linkTrendText({ state: 'worse', secondsLeft: null, sentence })).toBe(sentence);
    expect(linkTrendText({ state: 'falling', secondsLeft: 40, sentence })).toBe(sentence);
    expect(trendTone({ state: 'worse', secondsLeft: null, sentence })).toBe('amber');
    expect(trendTone({ state: 'falling', secondsLeft: 40, sentence })).toBe('red');
  });
});
