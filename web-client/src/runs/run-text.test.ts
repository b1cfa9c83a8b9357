import { describe, expect, it } from 'vitest';
import type { Barrier, Figures, RunWaypoint } from '../api/runs';
import type { Zone } from '../api/zones';
import { aRun, aRunDrone as drone, aRunWaypoint as waypoint, aDrone } from '../testing';
import {
  resumeText,
  costText,
  countsText,
  isInTheAir,
  joinable,
  mayGiveUp,
  mayResume,
  movedTexts,
  replayText,
  sharesOf,
  sortedWaypoints,
  stageLook,
  stateText,
  taskText,
  triggerText,
  waypointText,
} from './run-text';
import { ownBarriers, runFeatures } from './run-features';

const NOW = Date.parse('2026-01-01T12:00:00Z');

function figures(longestSeconds: number, cost: number, unserved = 0): Figures {
  return { longestSeconds, cost, unserved };
}

describe('a mission run in words', () => {
  it('says how far it is, and what it waits for', () => {
    const proposal = {
      number: 1,
      at: '',
      words: '',
      moved: [],
      before: figures(1, 1),
      after: figures(1, 1),
    };
    expect(stateText(aRun())).toBe('Under way');
    expect(stateText(aRun({ proposal }))).toBe('Waits for your answer');
    expect(stateText(aRun({ state: 'paused' }))).toBe('Paused: drones hold where they are');
    expect(stateText(aRun({ state: 'stopping' }))).toBe('Ending: its drones return');
    expect(stateText(aRun({ state: 'over', end: 'The run is over: all 3 waypoints visited.' }))).toBe(
      'The run is over: all 3 waypoints visited.',
    );
  });

  it('does not count what was cancelled, and never hides what was left out', () => {
    const counts = { waypoints: 5, visited: 2, unserved: 1, cancelled: 2, replans: 0, doubles: 0 };
    expect(countsText(aRun({ counts }))).toBe('2 of 3 waypoints visited, 1 left out');
    expect(sharesOf(aRun()).map((share) => [share.state, share.count])).toEqual([
      ['visited', 1],
      ['assigned', 1],
      ['reserved', 1],
    ]);
  });

  it('shows of each waypoint who, when or why not', () => {
    const run = aRun();
    const due = '2026-01-01T12:00:45Z';
    expect(waypointText(run, waypoint('2', { due }), NOW)).toBe('to be visited by Falcon, in 45 s');
    expect(waypointText(run, waypoint('2', { due: '2026-01-01T11:59:59Z' }), NOW)).toBe(
      'to be visited by Falcon',
    );
    expect(waypointText(run, run.waypoints[0] as RunWaypoint, NOW)).toBe('visited by Heron');
    const twice = waypoint('2', {
      state: 'visited',
      visits: [
        { drone: 'd1', at: '' },
        { drone: 'd2', at: '' },
      ],
    });
    expect(waypointText(run, twice, NOW)).toBe('visited by Falcon, then Heron');
    expect(waypointText(run, waypoint('2', { state: 'unserved', why: 'No drone was left.' }), NOW)).toBe(
      'left out: No drone was left.',
    );
  });

  it('shows what became of a task, and what is not known of it', () => {
    const photo = { type: 'photo', drone: 'd1', at: '', photo: 3 } as const;
    expect(taskText({ ...photo, result: 'done', words: 'Photo 3 at 47.397700, 8.545600.' })).toBe(
      'Photo: done. Photo 3 at 47.397700, 8.545600.',
    );
    expect(taskText({ ...photo, type: 'servo', result: 'notKnown', words: 'It was told to.' })).toBe(
      'Servo: unknown. It was told to.',
    );
    expect(taskText({ ...photo, type: 'readSensors', result: 'open', words: null })).toBe(
      'Read sensors: not yet.',
    );
  });

  it('puts first what somebody would look for', () => {
    const run = aRun({
      waypoints: [
        waypoint('1', { state: 'visited' }),
        waypoint('2', { due: '2026-01-01T12:01:00Z' }),
        waypoint('3', { state: 'unserved' }),
        waypoint('4', { due: '2026-01-01T12:00:30Z' }),
      ],
    });
    expect(sortedWaypoints(run).map((one) => one.id)).toEqual(['3', '4', '2', '1']);
  });

  it('shows of a decision what moved from whom to whom, and the cost before and after', () => {
    const moved = [
      { waypoint: '3', from: 'd1', to: 'd2' },
      { waypoint: '4', from: 'd1', to: 'd2' },
      { waypoint: '5', from: null, to: 'd1' },
    ];
    expect(movedTexts(aRun(), moved)).toEqual(['3, 4: Falcon to Heron', '5: nobody to Falcon']);
    expect(costText(figures(60, 61.26), figures(75, 1234.5, 1))).toBe(
      'all back in 1 min 00 s → 1 min 15 s, cost 61.3 → 1,235, left out 0 → 1',
    );
    expect(costText(null, figures(1, 1))).toBeNull();
    expect(triggerText({ trigger: 'lowBattery' })).toBe('Low battery');
    expect(triggerText({ trigger: 'newOne' as never })).toBe('newOne');
  });

  it('knows which drones can be resumed, called home and held', () => {
    expect(mayResume(drone('d1', { stage: 'suspended' }))).toBe(true);
    expect(mayResume(drone('d1'))).toBe(false);
    expect(mayResume(drone('d1', { stage: 'crashed' }))).toBe(false);
    expect(mayGiveUp(drone('d1', { stage: 'crashed' }))).toBe(false);
    expect(mayGiveUp(drone('d1'))).toBe(true);
    expect(isInTheAir(drone('d1', { stage: 'holding' }))).toBe(true);
    expect(isInTheAir(drone('d1', { stage: 'ready' }))).toBe(false);
    expect(stageLook(drone('d1', { stage: 'suspended' })).words).toBe('under other control');
    expect(stageLook(drone('d1', { next: ['2'] })).words).toBe('flying');
    expect(stageLook(drone('d1')).words).toBe('finishing');
  });

  it('lets drones join that are not in it and could be planned with', () => {
    const known = { battery: { percent: 90, voltage: null, current: null } } as object;
    const free = aDrone({ id: 'd3', ...known });
    expect(
      joinable(aRun(), [
        aDrone({ id: 'd1', ...known }),
        free,
        aDrone({ id: 'd4', flight: 'inAir', ...known }),
      ]),
    ).toEqual([free]);
  });

  it('gives the verdict on its journal', () => {
    const replay = { same: true, entries: 12, number: null, written: null, decided: null };
    expect(replayText(replay)).toBe('Replayed 12 entries: no difference.');
    expect(replayText({ ...replay, same: false, number: 7 })).toBe('Entry 7 differs in the replay.');
  });
});

describe('a mission run on the map', () => {
  it('shows waypoints by colour and mark, the way still to go, and what is marked', () => {
    const drawn = runFeatures(aRun(), '2', [{ latitude: 47.9, longitude: 8 }], () => ({
      latitude: 47,
      longitude: 8,
    }));
    const [way, ...points] = drawn.features;
    expect(way?.geometry).toEqual({
      type: 'LineString',
      coordinates: [
        [8, 47],
        [8, 47.2],
      ],
    });
    expect(points.map((point) => [point.properties?.['label'], point.properties?.['look']])).toEqual([
      ['1 ✓', 'green'],
      ['2', 'violet'],
      ['3 ?', 'amber'],
      ['+', 'mark'],
    ]);
    expect(points[1]?.properties?.['chosen']).toBe(true);
  });

  it('shows no ways of a run that is over', () => {
    const over = aRun({ state: 'over' });
    expect(runFeatures(over, null, [], () => null).features.map((one) => one.geometry.type)).toEqual([
      'Point',
      'Point',
      'Point',
    ]);
  });

  it('shows what the run alone keeps to beside the zones of the cloud', () => {
    const circle = (name: string, longitude: number): Barrier => ({
      type: 'Feature',
      geometry: { type: 'Point', coordinates: [longitude, 47] },
      properties: {
        name,
        kind: 'exclusion',
        radius: 50,
        floor: null,
        ceiling: null,
        altitudeReference: 'home',
      },
    });
    const school = circle('School', 8);
    const everybodys: Zone = {
      ...school,
      id: 'z1',
      properties: {
        ...school.properties,
        user: null,
        drone: null,
        from: null,
        until: null,
        onBreach: 'hold',
        by: null,
        changedAt: '2026-01-01T11:00:00Z',
      },
    };
    const run = aRun({ barriers: [school, circle('Crane', 8.1)] });
    expect(ownBarriers(run, [everybodys]).map((one) => one.properties.name)).toEqual(['Crane']);
    expect(ownBarriers(null, [everybodys])).toEqual([]);
    expect(ownBarriers(aRun({ barriers: [school, circle('School', 8)] }), [])).toHaveLength(1);
  });
});

describe('what a paused run does when it goes on', () => {
  it('is shown with the drones that move', () => {
    const drones = [
      drone('d1', { stage: 'holding', next: ['2'] }),
      drone('d2', { stage: 'ready', next: ['3'] }),
    ];
    expect(resumeText(aRun({ state: 'paused', drones }))).toBe('At once: Falcon flies on, Heron takes off.');
    expect(resumeText(aRun({ state: 'paused', drones: [drone('d1')] }))).toBeNull();
  });
});
