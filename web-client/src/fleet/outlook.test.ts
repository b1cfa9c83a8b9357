import { cleanup, render, screen } from '@testing-library/svelte';
import { afterEach, describe, expect, it } from 'vitest';
import type { Outlook } from '../api/control';
import { STATION, Station } from '../state/station.svelte';
import { aDrone, anOutlook } from '../testing';
import { minuteOfDay } from '../ui/format';
import FleetRow from './FleetRow.svelte';
import { batteryText, countdownOf, landingText, landsElsewhere, noticeOf, spokenCountdown } from './outlook';

const NOON = Date.parse('2026-01-01T12:00:00Z');

const flying = (change: Partial<Outlook> = {}) => aDrone({ flight: 'inAir', outlook: anOutlook(change) });

afterEach(cleanup);

describe('what becomes of a drone', () => {
  it('counts down to where it is brought', () => {
    expect(countdownOf(flying(), NOON)).toEqual({ words: 'Brought home in 12 s', tone: 'amber' });
    expect(countdownOf(flying(), NOON + 11_100)?.words).toBe('Brought home in 1 s');
    expect(countdownOf(flying(), NOON + 15_000)?.words).toBe('Brought home now');
    expect(countdownOf(flying({ comesDown: 'where it is' }), NOON)?.words).toBe('Brought down in 12 s');
    const circles = flying({ comesDown: null, latitude: null, longitude: null });
    expect(countdownOf(circles, NOON)?.words).toBe('Brought home in 12 s');
    expect(noticeOf(circles, null)?.words).toBe('No control · home');
    expect(landingText(circles)).toBeNull();
  });

  it('counts nothing where somebody has it, on the ground, or without a connection', () => {
    expect(countdownOf(flying({ returnsAt: null }), NOON)).toBeNull();
    expect(countdownOf(aDrone(), NOON)).toBeNull();
    expect(countdownOf(flying(), null)).toBeNull();
    expect(noticeOf(flying(), null)?.words).toBe('No control · home');
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

  it('is red where nothing can be done for it', () => {
    const helpless = flying({
      state: 'helpless',
      comesDown: null,
      latitude: null,
      longitude: null,
      returnsAt: null,
    });
    expect(countdownOf(helpless, NOON)).toEqual({ words: 'No safe landing place known', tone: 'red' });
    expect(noticeOf(helpless, null)?.words).toBe('No control · no safe landing');
    expect(spokenCountdown(helpless, NOON)).toBe('No safe landing place known: take control of it.');
    expect(landingText(helpless)).toBeNull();
  });

  it('is no alarm where somebody has it, or where it is not for this cloud to bring down', () => {
    const nowhere = { comesDown: null, latitude: null, longitude: null, returnsAt: null };
    expect(noticeOf(flying({ ...nowhere, state: 'kept' }), NOON)).toBeNull();
    expect(noticeOf(flying({ ...nowhere, state: 'leftAlone' }), NOON)).toBeNull();
    expect(landsElsewhere(flying(nowhere))).toBeNull();
  });

  it('shows how far away it comes down, but not of a place where it is', () => {
    expect(landingText(flying())).toBe('home, 500 m away');
    expect(landingText(flying({ latitude: 47.39771, comesDown: 'where it is' }))).toBe('where it is');
    expect(landingText(flying({ latitude: null, longitude: null }))).toBe('home');
    expect(landingText({ ...flying(), position: null })).toBe('home');
    expect(landsElsewhere(flying())).toEqual({ latitude: 47.4022, longitude: 8.5456 });
    expect(landsElsewhere(flying({ latitude: 47.39771 }))).toBeNull();
  });

  it('shows until when its battery lasts, in the time of day and in minutes', () => {
    const at = minuteOfDay('2026-01-01T12:32:00Z');
    expect(at).not.toMatch(/:\d\d:/);
    expect(batteryText(anOutlook(), NOON)).toBe(`until about ${at} (32 min)`);
    expect(batteryText(anOutlook(), NOON + 31.5 * 60_000)).toBe(`until about ${at} (less than 1 min)`);
    expect(batteryText(anOutlook({ emptyAt: null }), NOON)).toBeNull();
  });

  it('marks a row by words', async () => {
    const station = new Station();
    station.connection.up();
    station.clock.now = NOON;
    const props = { drone: flying(), selected: false, onselect: () => undefined };
    const { rerender } = render(FleetRow, { props, context: new Map([[STATION, station]]) });
    expect(screen.getByText('No control · home in 12 s').className).toContain('amber');
    expect(screen.queryByText(/Multicopter/)).toBeNull();

    await rerender({ drone: flying({ returnsAt: null }) });
    expect(screen.queryByText(/Nobody’s/)).toBeNull();
    expect(screen.getByText(/· Multicopter/)).toBeDefined();
  });
});
