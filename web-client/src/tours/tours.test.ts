import { describe, expect, it } from 'vitest';
import type { FleetPlan, PlanProgress, PlanTour } from '../api/plans';
import { addWaypoint, changeWaypoint, emptyDraft } from '../plan/draft';
import { Tours } from '../state/tours.svelte';
import { barsOf, flightLine, gapLine, stateLine, waypointsOf } from './tour-line';
import { tourFeatures } from './tour-features';

const PLACES = new Map([
  ['1', { latitude: 47.1, longitude: 8.1 }],
  ['2', { latitude: 47.2, longitude: 8.2 }],
]);
const HOME = { latitude: 47, longitude: 8 };

function progress(change: Partial<PlanProgress>): PlanProgress {
  return { seconds: 1, longestSeconds: 100, sum: 0, unserved: 0, gap: 0.1, iterations: 1, ...change };
}

function tour(drone: string, change: Partial<PlanTour> = {}): PlanTour {
  return {
    drone,
    name: drone,
    departsSeconds: 0,
    endsSeconds: 100,
    distance: 1200,
    wattHours: 8.04,
    batteryShare: 0.25,
    stops: [],
    back: [],
    ...change,
  };
}

function plan(change: Partial<FleetPlan>): FleetPlan {
  return {
    id: 'p1',
    state: 'running',
    why: null,
    seconds: 5,
    drones: [
      { id: 'd1', name: 'Falcon' },
      { id: 'd2', name: 'Heron' },
    ],
    waypoints: 2,
    progress: null,
    improvements: [],
    orders: null,
    result: null,
    launch: null,
    ...change,
  };
}

describe('a plan for several drones', () => {
  it('never calls itself better than it is proved to be', () => {
    expect(gapLine(progress({ gap: 0.071 }))).toBe('The best plan there is may be up to 8 % better.');
    expect(gapLine(progress({ gap: 0 }))).toBe('This is the best plan there is.');
    expect(gapLine(progress({ gap: 1, unserved: 2 }))).toBe('2 waypoints left out.');
  });

  it('says how far it is', () => {
    expect(stateLine(plan({}))).toBe('Looking for a first plan …');
    expect(stateLine(plan({ progress: progress({ longestSeconds: 100 }) }))).toBe(
      'Getting better: all done after 1 min 40 s.',
    );
    expect(stateLine(plan({ state: 'failed', why: 'No.' }))).toBe('No.');
    expect(flightLine({ drone: 'd1', name: 'd1', stage: 'failed', why: 'No.', command: null })).toBe(
      'failed: No.',
    );
  });

  it('compares the drones by time, distance and energy', () => {
    const short = tour('d2', { endsSeconds: 50, distance: 600, wattHours: 4.02 });
    expect(barsOf(short, [tour('d1'), short])).toEqual([
      { label: 'time', value: '50 s', share: 0.5 },
      { label: 'distance', value: '600 m', share: 0.5 },
      { label: 'energy', value: '4.0 Wh, 25 %', share: 0.5 },
    ]);
  });

  it('is drawn straight while it is searched for, from each drone and back', () => {
    const drawn = tourFeatures(
      plan({
        orders: [
          { drone: 'd1', waypoints: [] },
          { drone: 'd2', waypoints: ['2', '1'] },
        ],
      }),
      PLACES,
      () => HOME,
    );
    expect(drawn.features).toHaveLength(1);
    expect(drawn.features[0]?.properties).toEqual({ tone: 1, label: 'Heron' });
    expect(drawn.features[0]?.geometry).toEqual({
      type: 'LineString',
      coordinates: [
        [8, 47],
        [8.2, 47.2],
        [8.1, 47.1],
        [8, 47],
      ],
    });
  });

  it('is drawn as it is flown once it is found, and not when it was cancelled', () => {
    const place = { latitude: 47.5, longitude: 8.5, altitudeAmsl: 500 };
    const result = {
      endsSeconds: 1,
      tours: [
        tour('d1', { stops: [{ ...place, waypoint: '1', arrivesSeconds: 1, via: [place] }], back: [place] }),
      ],
      unserved: [],
      faults: [],
      assumed: true,
    };
    const found = tourFeatures(plan({ state: 'finished', result }), PLACES, () => HOME);
    expect(found.features[0]?.geometry).toMatchObject({
      coordinates: [
        [8, 47],
        [8.5, 47.5],
        [8.5, 47.5],
        [8.5, 47.5],
      ],
    });
    expect(tourFeatures(plan({ state: 'cancelled' }), PLACES, () => HOME).features).toEqual([]);
  });

  it('asks for the waypoints of the editor that have an altitude', () => {
    const draft = addWaypoint(addWaypoint(emptyDraft(), HOME, 20), HOME, 30);
    expect(waypointsOf(changeWaypoint(draft, 1, { altitude: null }))).toEqual([
      { id: '2', ...HOME, altitude: 30, altitudeReference: 'home', holdSeconds: null },
    ]);
  });

  it('hears only of the plan that is shown, and tells why one was refused', async () => {
    const calls = {
      ask: () => Promise.resolve(plan({})),
      accept: () => Promise.reject(new Error('It has moved.')),
      remove: () => Promise.resolve(),
    };
    const tours = new Tours(calls as unknown as ConstructorParameters<typeof Tours>[0]);
    await tours.ask([]);
    tours.hear(plan({ id: 'other', state: 'finished' }));
    expect(tours.plan?.state).toBe('running');
    tours.hear(plan({ state: 'finished' }));
    expect(tours.plan?.state).toBe('finished');
    await tours.accept(true);
    expect(tours.problem).not.toBeNull();
    tours.forget('p1');
    expect(tours.plan).toBeNull();
  });
});
