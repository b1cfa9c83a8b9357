import { describe, expect, it } from 'vitest';
import { aZone } from '../testing';
import { importText, leftOutText } from './import-text';

const line = { at: 'features[1]', name: 'Road', code: 'value-not-allowed', why: 'A line is no area.' };

describe('what became of a file with zones', () => {
  it('says how many were added', () => {
    expect(importText({ zones: [aZone()], leftOut: [], leftOutTotal: 0 })).toBe('1 zone added.');
  });

  it('says how much was left out, and how much of that is shown', () => {
    expect(importText({ zones: [], leftOut: [line], leftOutTotal: 1 })).toBe(
      '0 zones added. Left out: 1 thing of the file.',
    );
    expect(importText({ zones: [], leftOut: [line], leftOutTotal: 3 })).toBe(
      '0 zones added. Left out: 3 things of the file, the first 1 here.',
    );
  });

  it('says what it is, where it stands and why', () => {
    expect(leftOutText(line)).toBe('Road (features[1]): A line is no area.');
    expect(leftOutText({ ...line, name: null })).toBe('features[1]: A line is no area.');
  });
});
