import { cleanup, render } from '@testing-library/svelte';
import { flushSync, tick } from 'svelte';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { Zone } from '../api/zones';
import type { Coordinates } from '../geo/coordinates';
import { STATION, Station } from '../state/station.svelte';
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

const SCHOOL: Zone = {
  type: 'Feature',
  id: 'z1',
  geometry: { type: 'Point', coordinates: [8, 47] },
  properties: {
    name: 'School',
    kind: 'exclusion',
    radius: 100,
    floor: null,
    ceiling: null,
    altitudeReference: 'home',
    user: null,
    drone: null,
    from: null,
    until: null,
    onBreach: 'hold',
  },
};

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

    station.zones.wanted = { zone: SCHOOL };
    flushSync();
    expect(opened.fitted).toHaveLength(1);

    opened.events?.onMove(true);
    flushSync();
    expect(opened.fitted).toHaveLength(1);
  });
});
