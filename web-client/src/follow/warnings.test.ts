import { describe, expect, it } from 'vitest';
import { warningsFor, type PhoneStatus } from './warnings';

const NOW = Date.parse('2026-01-01T12:00:00Z');
const well: PhoneStatus = {
  now: NOW,
  leading: true,
  idle: false,
  demo: false,
  locating: 'on',
  lastFix: NOW - 1000,
  accuracy: 5,
  absence: null,
  meantime: '',
  patience: 60,
  cutOffSince: null,
  online: false,
  refused: null,
  wake: 'held',
  battery: 80,
};
const keys = (change: Partial<PhoneStatus>): string[] =>
  warningsFor({ ...well, ...change }).map(({ key }) => key);
const words = (change: Partial<PhoneStatus>): string =>
  warningsFor({ ...well, ...change })
    .map((warning) => `${warning.words} ${warning.todo}`)
    .join(' ');

describe('warnings', () => {
  it('are none while all is well', () => {
    expect(keys({})).toEqual([]);
  });

  it('show for how long there is no position, and what the drone does', () => {
    expect(keys({ lastFix: NOW - 3900 })).toEqual([]);
    expect(words({ lastFix: NOW - 12_300 })).toContain(
      'No position for 12 s. The drone stands, and flies home in 48 s.',
    );
    expect(words({ lastFix: NOW - 61_000 })).toContain('By now the drone flies home.');
    expect(words({ lastFix: NOW - 12_300, patience: null })).toContain('The drone stands and waits.');
    expect(words({ lastFix: NOW - 12_300, leading: false })).not.toContain('drone stands');
    // While the phone is cut off nobody knows that.
    expect(words({ lastFix: NOW - 12_300, cutOffSince: NOW })).not.toContain('drone stands');
    expect(keys({ lastFix: null, locating: 'unavailable' })).toEqual(['no-fix']);
  });

  it('do not ask for a position when nothing hangs on it', () => {
    const lost = { lastFix: NOW - 12_300, leading: false, idle: true };
    expect(keys(lost)).toEqual([]);
    expect(keys({ ...lost, locating: 'denied' })).toEqual([]);
    expect(keys({ ...lost, accuracy: 80 })).toEqual([]);
    expect(keys({ ...lost, cutOffSince: NOW })).toEqual(['cut-off']);
  });

  it('show apart that the page may not know', () => {
    expect(keys({ locating: 'denied', lastFix: NOW - 60_000 })).toEqual(['denied']);
    expect(words({ locating: 'denied' })).toContain('Allow location');
  });

  it('show since when it is cut off', () => {
    const shown = words({ cutOffSince: NOW - 31_000 });
    expect(shown).toContain('31 s ago');
    expect(shown).toContain('goes on by itself when the network is back');
    expect(words({ cutOffSince: NOW, online: true })).toContain('when the cloud answers');
  });

  it('show what had kept the phone away and what the drone did, for a while', () => {
    const absence = { seconds: 34, waited: 32, from: NOW - 35_000, until: NOW - 1000 };
    const meantime = 'The drone stood and waited for 32 s.';
    const shown = (['asleep', 'cut', 'unanswered', 'gone', 'blind', 'vague'] as const).map((why) =>
      words({ absence: { ...absence, why }, meantime }),
    );
    expect(shown.map((one) => one.slice(0, one.indexOf(' 34 s')))).toEqual([
      'This page was stopped for',
      'There was no network for',
      'The cloud did not answer for',
      'This page was closed for',
      'The phone did not know where it is for',
      'The phone knew its place to no better than 50 m for',
    ]);
    shown.forEach((one) => expect(one).toContain(meantime));
    // After the drone was spoken of, "it" would be the drone.
    shown.forEach((one) => expect(one).not.toContain('Keep it'));
    const long = { ...absence, why: 'cut' as const };
    expect(keys({ absence: { ...long, until: NOW - 40_000 } })).toEqual([]);
    expect(keys({ absence: long, leading: false })).toEqual([]);
  });

  it('show how bad a position is, and from when on it leads nobody', () => {
    expect(keys({ accuracy: 14 })).toEqual([]);
    expect(warningsFor({ ...well, accuracy: 30 })[0]?.tone).toBe('amber');
    expect(warningsFor({ ...well, accuracy: 80 })[0]?.tone).toBe('red');
    expect(words({ accuracy: 80 })).toContain('only known to 80 m');
    expect(warningsFor({ ...well, accuracy: 80 })[0]?.todo).toContain('flies home when that stays so for');
    expect(warningsFor({ ...well, leading: false, accuracy: 80 })[0]?.todo).not.toContain('flies home');
  });

  it('show that the screen may go off, unless a recorded walk needs none', () => {
    expect(keys({ wake: 'unsupported' })).toEqual(['screen-off']);
    expect(keys({ wake: 'refused', demo: true })).toEqual([]);
  });

  it('put what stops the drone before what only may', () => {
    const absence = { why: 'cut' as const, seconds: 9, waited: 7, from: NOW - 9_000, until: NOW };
    expect(keys({ wake: 'refused', battery: 25, cutOffSince: NOW, absence })).toEqual([
      'cut-off',
      'screen-off',
      'battery',
    ]);
    expect(keys({ wake: 'refused', absence })).toEqual(['back', 'screen-off']);
  });

  it('say the words of the cloud when it does not want the positions', () => {
    expect(words({ refused: 'Only ann says where the phone is.' })).toContain('Only ann says');
  });
});
