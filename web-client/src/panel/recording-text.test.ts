import { describe, expect, it } from 'vitest';
import type { Recording } from '../api/recordings';
import { recordingText, size } from './recording-text';

const FLIGHT: Recording = {
  id: '20260304T050607Z_d1',
  drone: 'd1',
  droneName: 'Copter 1',
  start: '2026-03-04T05:06:07Z',
  end: '2026-03-04T05:08:20Z',
  seconds: 132.7,
  bytes: 1_234_567,
  frames: 20_000,
  drops: 0,
  state: 'complete',
  notice: null,
};

describe('the text of a flight', () => {
  it('says how long it took and how large it is', () => {
    expect(recordingText(FLIGHT)).toBe('2 min 13 s · 1.2 MB');
  });

  it('says that a flight goes on', () => {
    expect(recordingText({ ...FLIGHT, end: null, seconds: null, bytes: 200 })).toBe('going on · 1 kB');
  });

  it('writes sizes in the unit that fits', () => {
    expect([size(999_000), size(1e6), size(2.5e9)]).toEqual(['999 kB', '1.0 MB', '2.50 GB']);
  });
});
