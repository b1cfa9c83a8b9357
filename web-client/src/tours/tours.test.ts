import { describe, expect, it } from 'vitest';
import type { FleetPlan, PlanProgress, PlanTour } from '../api/plans';
import { Problem } from '../api/problem';
import { addWaypoint, changeWaypoint, emptyDraft, reordered } from '../plan/draft';
import { Tours } from '../state/tours.svelte';
import { NO_REQUIREMENTS } from './requirements';
import {
  barsOf,
  compared,
  flightText,
  gapText,
  orderText,
  stateText,
  stepsOf,
  waypointsOf,
} from './tour-text';
import { tourFeatures } from './tour-features';
import { whyRequirementsInvalid, whyOptionsInvalid } from './plan-limits';

const PLACES = new Map([
  ['1', { latitude: 47.1, longitude: 8.1 }],
  ['2', { latitude: 47.2, longitude: 8.2 }],
]);
const HOME = { latitude: 47, longitude: 8 };

const RESULT = { endsSeconds: 1, tours: [], unserved: [], faults: [], assumed: true };

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
    by: 'ann',
    askedAt: '2026-01-01T12:00:00Z',
    seed: 1,
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
    expect(gapText(progress({ gap: 0.071 }))).toBe('The best plan there is may be up to 8 % better.');
    expect(gapText(progress({ gap: 0 }))).toBe('This is the best plan there is.');
    expect(gapText(progress({ gap: 1, unserved: 2 }))).toBe('2 waypoints left out.');
  });

  it('says how far it is', () => {
    expect(stateText(plan({}))).toBe('Looking for a first plan …');
    expect(stateText(plan({ progress: progress({ longestSeconds: 100 }) }))).toBe(
      'Getting better: all done after 1 min 40 s.',
    );
    expect(stateText(plan({ state: 'failed', why: 'No.' }))).toBe('No.');
    expect(
      flightText({ drone: 'd1', name: 'd1', stage: 'failed', why: 'No.', code: 'not-armed', command: null }),
    ).toBe('failed: No.');
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
    const times = { arrivesSeconds: 1, beginsSeconds: 1, leavesSeconds: 1 };
    const stop = { ...place, ...times, waypoint: '1', wattHours: 1, via: [place] };
    const result = {
      endsSeconds: 1,
      tours: [tour('d1', { stops: [stop], back: [place] })],
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

  it('asks for what each waypoint wants, and for the rest of nothing', () => {
    const draft = addWaypoint(addWaypoint(emptyDraft(), HOME, 20), HOME, 30);
    const wants = {
      ...NO_REQUIREMENTS,
      priority: 10,
      opens: null,
      closes: 60,
      picture: true,
      photo: true,
      servo: 9,
      pulse: 1900,
      sensors: 5,
    };
    const [first, second] = waypointsOf(draft, (key) => (key === 2 ? wants : NO_REQUIREMENTS));
    expect(Object.keys(first ?? {})).not.toContain('priority');
    expect(second).toMatchObject({
      priority: 10,
      window: { opens: null, closes: 60 },
      needs: ['takePicture'],
      tasks: [
        { type: 'servo', output: 9, pulse: 1900 },
        { type: 'photo' },
        { type: 'readSensors', seconds: 5 },
      ],
    });
    expect(Object.keys(first ?? {})).not.toContain('tasks');
    expect(whyRequirementsInvalid({ ...wants, pulse: null }, 2)).toBe(
      'The servo of waypoint 2 needs an output from 1 to 32 and 500 to 2500 µs.',
    );
    expect(whyRequirementsInvalid({ ...wants, sensors: 0 }, 2)).toBe(
      'Sensors are read for 1 to 3600 seconds at waypoint 2.',
    );
    expect(whyRequirementsInvalid({ ...wants, opens: 61 }, 2)).toBe('Waypoint 2 ends before it begins.');
    expect(whyOptionsInvalid({ seconds: 5, windSpeed: 4, windFrom: null })).toBe(
      'Enter where the wind comes from.',
    );
    expect(whyOptionsInvalid({ seconds: 61, windSpeed: null, windFrom: null })).toBe(
      'Search for 0.1 to 60 seconds.',
    );
    expect(whyOptionsInvalid({ seconds: 5, windSpeed: 4, windFrom: 270 })).toBeNull();
  });

  it('marks on the map what nobody visits', () => {
    const place = { latitude: 47.5, longitude: 8.5, altitudeAmsl: 500 };
    const result = { ...RESULT, unserved: [{ waypoint: '2', why: 'It is too far.', place }] };
    expect(
      tourFeatures(plan({ state: 'finished', result }), PLACES, () => HOME).features.at(-1),
    ).toMatchObject({
      properties: { unserved: true, label: '2 ✕' },
      geometry: { type: 'Point', coordinates: [8.5, 47.5] },
    });
  });

  it('is compared with another one line by line, less being better', () => {
    const here = { ...RESULT, endsSeconds: 90, tours: [tour('d1'), tour('d2')] };
    const there = { ...RESULT, endsSeconds: 120, tours: [tour('d1', { departsSeconds: 10 })] };
    const lines = new Map(compared(here, there).map((line) => [line.label, line]));
    expect(lines.get('all done after')).toMatchObject({
      here: '1 min 30 s',
      there: '2 min 00 s',
      better: 'here',
    });
    expect(lines.get('flying in all')).toMatchObject({
      here: '3 min 20 s',
      there: '1 min 30 s',
      better: 'there',
    });
    expect(lines.get('left out')?.better).toBeNull();
  });

  it('draws how it got better, without what was no whole plan yet', () => {
    const steps = [
      progress({ seconds: 0, longestSeconds: 50, unserved: 3 }),
      progress({ seconds: 1, longestSeconds: 200 }),
      progress({ seconds: 2.5, longestSeconds: 100 }),
    ];
    expect(stepsOf(steps, 5)).toBe('20.0,0.0 20.0,0.0 50.0,0.0 50.0,100.0 100,100.0');
    expect(stepsOf(steps.slice(0, 2), 5)).toBe('');
  });

  it('shows what a better order saves, and changes the draft only as a whole', () => {
    const line = orderText({
      order: [1, 0],
      before: { seconds: 100, distance: 900 },
      after: { seconds: 70, distance: 640 },
      gap: 0,
      unserved: [],
    });
    expect(line).toBe('640 m instead of 900 m, 1 min 10 s instead of 1 min 40 s. Undo takes it back.');
    const draft = addWaypoint(addWaypoint(emptyDraft(), HOME, 20), HOME, 30);
    expect(reordered(draft, [1, 0]).waypoints.map((one) => one.key)).toEqual([2, 1]);
    expect(reordered(draft, [1, 1])).toBe(draft);
    expect(reordered(draft, [1])).toBe(draft);
  });

  it('shows the plan that was asked for, keeps the one before beside it, and tells why one was refused', async () => {
    let asked = 0;
    const bodies: unknown[] = [];
    const calls = {
      ask: (body: unknown) => {
        bodies.push(body);
        return Promise.resolve(plan({ id: `p${++asked}` }));
      },
      accept: () => Promise.reject(new Error('It has moved.')),
      one: () => Promise.reject(new Problem({ status: 404, detail: 'There is no such plan.' })),
      remove: () => Promise.resolve(),
    };
    const tours = new Tours(calls as unknown as ConstructorParameters<typeof Tours>[0]);
    tours.aim = 'weighted';
    tours.balance = 25;
    tours.windSpeed = 4;
    tours.windFrom = 270;
    await tours.ask([]);
    expect(bodies[0]).toMatchObject({
      objective: { kind: 'weighted', longestWeight: 0.75, sumWeight: 0.25, everyDrone: false },
      wind: { speed: 4, from: 270 },
    });
    tours.apply(plan({ id: 'other', state: 'finished' }));
    expect(tours.plan?.state).toBe('running');
    tours.apply(plan({ state: 'finished', result: RESULT }));
    expect(tours.plan?.state).toBe('finished');
    await tours.accept(true);
    expect(tours.problem).toBe('It has moved.');

    await tours.ask([]);
    expect(tours.plan?.id).toBe('p2');
    expect(tours.beside?.id).toBe('p1');
    tours.show('p1');
    expect([tours.plan?.id, tours.beside?.id]).toEqual(['p1', 'p2']);
    await tours.catchUp();
    expect(tours.plan).toBeNull();
    expect(tours.problem).toContain('no longer knows this plan');
  });

  it('is found again after the page was opened anew, while something of it is under way', () => {
    const tours = new Tours({} as ConstructorParameters<typeof Tours>[0]);
    tours.apply(plan({ id: 'old', state: 'finished', result: RESULT }));
    expect(tours.plan).toBeNull();
    expect(tours.others.map((one) => one.id)).toEqual(['old']);
    tours.apply(plan({ id: 'running' }));
    expect(tours.plan?.id).toBe('running');
    tours.applyRemoval('running');
    expect(tours.plan).toBeNull();
  });
});
