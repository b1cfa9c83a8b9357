import { cleanup, render, screen } from '@testing-library/svelte';
import { afterEach, describe, expect, it } from 'vitest';
import sentences from '../../../dronemap-core/src/main/java/org/dronemap/core/cloud/OutlookWords.java?raw';
import type { Outlook } from '../api/control';
import { STATION, Station } from '../state/station.svelte';
import { aDrone, anOutlook } from '../testing';
import { minuteOfDay } from '../ui/format';
import FleetRow from './FleetRow.svelte';
import {
  batteryWords,
  countdownOf,
  DOES_NOTHING,
  landingWords,
  landsElsewhere,
  noticeOf,
  spokenCountdown,
  TIME_IS_OVER,
} from './outlook';

const NOON = Date.parse('2026-01-01T12:00:00Z');

const flying = (change: Partial<Outlook> = {}) => aDrone({ flight: 'inAir', outlook: anOutlook(change) });
const over = `${TIME_IS_OVER}; it is brought home.`;

afterEach(cleanup);

describe('what becomes of a drone', () => {
  it('counts down to where it is brought', () => {
    expect(countdownOf(flying(), NOON)).toEqual({ words: 'Brought home in 12 s', tone: 'amber' });
    expect(countdownOf(flying(), NOON + 11_100)?.words).toBe('Brought home in 1 s');
    expect(countdownOf(flying(), NOON + 15_000)?.words).toBe('Brought home now');
    expect(countdownOf(flying({ comesDown: 'where it is' }), NOON)?.words).toBe('Brought down in 12 s');
  });

  it('counts nothing where somebody has it, on the ground, or without a line', () => {
    expect(countdownOf(flying({ returnsAt: null }), NOON)).toBeNull();
    expect(countdownOf(aDrone(), NOON)).toBeNull();
    expect(countdownOf(flying(), null)).toBeNull();
    expect(noticeOf(flying(), null)?.words).toBe('Nobody’s · home');
  });

  it('speaks every ten seconds', () => {
    const spoken = [0, 1, 2, 3, 11, 12].map((second) => spokenCountdown(flying(), NOON + second * 1000));
    expect(new Set(spoken)).toEqual(
      new Set([
        'Brought home within 20 s unless somebody takes control.',
        'Brought home within 10 s unless somebody takes control.',
        'Brought home now.',
      ]),
    );
    expect(spokenCountdown(flying({ returnsAt: null }), NOON)).toBe('');
  });

  it('is red where there is no way down, before its time and after it', () => {
    const nowhere = { comesDown: null, latitude: null, longitude: null };
    for (const outlook of [nowhere, { ...nowhere, returnsAt: null, then: over }]) {
      expect(countdownOf(flying(outlook), NOON)).toEqual({ words: 'No safe way down is known', tone: 'red' });
      expect(noticeOf(flying(outlook), null)?.words).toBe('Nobody’s · no safe way down');
      expect(spokenCountdown(flying(outlook), NOON)).toBe('No safe way down is known: take control of it.');
    }
    expect(landingWords(flying(nowhere))).toBeNull();
  });

  it('is no alarm where somebody has it, or where it is not for this cloud to bring down', () => {
    const nowhere = { comesDown: null, returnsAt: null, then: over };
    const control = {
      state: 'held',
      holder: 'ann',
      explicit: true,
      since: null,
      epoch: 7,
      requests: [],
    } as const;
    expect(noticeOf({ ...flying(nowhere), control: { ...control, requests: [] } }, NOON)).toBeNull();
    const foreign = 'It was not commanded from here; this server leaves it alone.';
    expect(noticeOf(flying({ ...nowhere, then: foreign }), NOON)).toBeNull();
  });

  it('tells how far away it comes down, but not of a place where it is', () => {
    expect(landingWords(flying())).toBe('home, 500 m away');
    expect(landingWords(flying({ latitude: 47.39771, comesDown: 'where it is' }))).toBe('where it is');
    expect(landingWords(flying({ latitude: null, longitude: null }))).toBe('home');
    expect(landingWords({ ...flying(), position: null })).toBe('home');
    expect(landsElsewhere(flying())).toEqual({ latitude: 47.4022, longitude: 8.5456 });
    expect(landsElsewhere(flying({ latitude: 47.39771 }))).toBeNull();
  });

  it('tells of no place where the server does nothing', () => {
    for (const end of DOES_NOTHING) {
      const left = flying({ then: `When ann gives no sign for 6 s, ${end}`, returnsAt: null });
      expect(landingWords(left)).toBeNull();
      expect(landsElsewhere(left)).toBeNull();
    }
  });

  it('knows the sentences of the server', () => {
    [...DOES_NOTHING.map((end) => `${end}"`), `"${TIME_IS_OVER}`].forEach((part) =>
      expect(sentences).toContain(part),
    );
  });

  it('tells until when its battery lasts, in the time of day and in minutes', () => {
    const at = minuteOfDay('2026-01-01T12:32:00Z');
    expect(at).not.toMatch(/:\d\d:/);
    expect(batteryWords(anOutlook(), NOON)).toBe(`until about ${at} (32 min)`);
    expect(batteryWords(anOutlook(), NOON + 31.5 * 60_000)).toBe(`until about ${at} (less than 1 min)`);
    expect(batteryWords(anOutlook({ emptyAt: null }), NOON)).toBeNull();
  });

  it('marks a row by words', async () => {
    const station = new Station();
    station.connection.up();
    station.clock.now = NOON;
    const props = { drone: flying(), selected: false, onselect: () => undefined };
    const { rerender } = render(FleetRow, { props, context: new Map([[STATION, station]]) });
    expect(screen.getByText('Nobody’s · home in 12 s').className).toContain('amber');
    expect(screen.queryByText(/Multicopter/)).toBeNull();

    await rerender({ drone: flying({ returnsAt: null }) });
    expect(screen.queryByText(/Nobody’s/)).toBeNull();
    expect(screen.getByText(/· Multicopter/)).toBeDefined();
  });
});
