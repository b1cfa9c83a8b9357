import { cleanup, render } from '@testing-library/svelte';
import { flushSync, tick } from 'svelte';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { Coordinates } from '../geo/coordinates';
import { STATION, Station } from '../state/station.svelte';
import { aZone } from '../testing';
import type { MapEvents } from './flight-map';
import MapView from './MapView.svelte';

const opened = vi.hoisted(() => ({ events: null as MapEvents | null, fitted: [] as unknown[] }));

// Moves at once when it is told to show something, and says so, as MapLibre does without an animation.
vi.mock('./flight-map', () => ({
  FlightMap: class {
    constructor(_: HTMLElement, __: string | null, events: MapEvents) {
      opened.events = events;
    }
    fit(places: readonly Coordinates[]): void {
      opened.fitted.push(places);
      opened.events?.onMove(false);
    }
    show(): void {}
    setPlanning(): void {}
    dispose(): void {}
  },
}));

beforeEach(() => {
  opened.fitted = [];
  Object.defineProperty(document, 'fonts', {
    configurable: true,
    value: { load: () => Promise.resolve([]) },
  });
});
afterEach(cleanup);

describe('the map of the station', () => {
  it('shows a zone that is chosen once, and may be moved away from it', async () => {
    const station = new Station();
    render(MapView, { context: new Map([[STATION, station]]) });
    await vi.waitFor(() => expect(opened.events).not.toBeNull());
    await tick();

    station.zones.wanted = { zone: aZone() };
    flushSync();
    expect(opened.fitted).toHaveLength(1);

    opened.events?.onMove(true);
    flushSync();
    expect(opened.fitted).toHaveLength(1);
  });
});
