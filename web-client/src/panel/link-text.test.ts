import { describe, expect, it } from 'vitest';
import { lossTone, linkQualityText } from './link-text';

describe('the link line', () => {
  it('says what was lost and how long an answer takes', () => {
    expect(linkQualityText({ lossShort: 0.25, lossLong: 0.012, rttMs: 41.6 })).toBe(
      'Link: 25 % lost now, 1.2 % in a minute · round trip 42 ms',
    );
  });

  it('shows what is unknown as unknown', () => {
    expect(linkQualityText(undefined)).toBe('Link quality —');
    expect(linkQualityText({ lossShort: 0, lossLong: null, rttMs: null })).toBe(
      'Link: 0 % lost now, — in a minute · round trip —',
    );
  });

  it('turns amber when a pilot should know', () => {
    expect(lossTone({ lossShort: 0.06, lossLong: 0, rttMs: null })).toBe('amber');
    expect(lossTone({ lossShort: 0.01, lossLong: 0, rttMs: null })).toBe('neutral');
    expect(lossTone(undefined)).toBe('neutral');
  });
});
