import { describe, expect, it } from 'vitest';
import type { MissionItem } from '../api/types';
import { aDrone, aMission, anOutlook } from '../testing';
import { draftFeatures, droneFeatures, landingFeatures, missionFeatures, trailFeatures } from './features';
import { gridLines, gridStep } from './grid';
import { addWaypoint, emptyDraft } from '../plan/draft';
import { emptyLanding } from '../plan/landing';

const wp = (latitude: number) =>
  ({ type: 'waypoint', latitude, longitude: 8, altitude: 20, altitudeReference: 'home' }) as const;

describe('map features', () => {
  it('draws a drone with heading, state and label', () => {
    const [feature] = droneFeatures([aDrone()], 'd1', () => 0).features;
    expect(feature?.geometry.coordinates).toEqual([8.5456, 47.3977]);
    expect(feature?.properties).toMatchObject({
      icon: 'drone|arrow|neutral|plain',
      heading: 40,
      selected: true,
      opacity: 1,
      age: '',
    });
  });

  it('fades and crosses a lost drone and says how old its place is', () => {
    const drone = aDrone({ armed: true, link: { ...aDrone().link, state: 'lost' } });
    const [feature] = droneFeatures([drone], null, () => 12_000).features;
    expect(feature?.properties).toMatchObject({
      icon: 'drone|arrow|red|crossed',
      opacity: 0.55,
      age: '12 s ago',
    });
  });

  it('does not draw a drone whose place is unknown, and shows no heading it does not know', () => {
    expect(droneFeatures([aDrone({ position: null })], null, () => 0).features).toEqual([]);
    const [feature] = droneFeatures([aDrone({ motion: null })], null, () => 0).features;
    expect(feature?.properties?.['icon']).toContain('|dot|');
  });

  it('numbers the waypoints of the vehicle and tells reached, current and ahead apart', () => {
    const mission = {
      items: [{ type: 'takeOff', altitude: 20 } as const, wp(1), wp(2), wp(3)],
      current: 2,
      reached: [0, 1],
      total: 4,
      running: true,
      state: null,
      notice: null,
      hash: null,
    };
    const points = missionFeatures(aDrone({ mission })).features.filter(
      (one) => one.geometry.type === 'Point',
    );
    expect(points.map((one) => [one.properties?.['label'], one.properties?.['state']])).toEqual([
      ['2', 'reached'],
      ['3', 'current'],
      ['4', 'ahead'],
    ]);
  });

  it('leads the planned way home when the plan ends with a return', () => {
    const draft = { ...addWaypoint(emptyDraft(), { latitude: 47.5, longitude: 8.5 }, 20) };
    expect(draftFeatures(draft, aDrone()).features).toHaveLength(1);
    const [way] = draftFeatures({ ...draft, ending: 'returnToLaunch' }, aDrone()).features;
    expect(way?.geometry).toEqual({
      type: 'LineString',
      coordinates: [
        [8.5, 47.5],
        [8.5456, 47.3977],
      ],
    });
  });

  it('shows where a mission lands, planned and on the vehicle, and the way there', () => {
    const land = { latitude: 47.6, longitude: 8.6 };
    const draft = {
      ...addWaypoint(emptyDraft(), { latitude: 47.5, longitude: 8.5 }, 20),
      ending: 'land' as const,
      landing: { ...emptyLanding(), place: land },
    };
    const way = [
      [8.5, 47.5],
      [8.6, 47.6],
    ];
    const planned = draftFeatures(draft, aDrone()).features;
    expect(planned[0]?.geometry).toMatchObject({ coordinates: way });
    expect(planned[2]?.properties).toEqual({ key: 0, label: '3', words: 'Land' });
    const items: MissionItem[] = [
      { type: 'waypoint', latitude: 47.5, longitude: 8.5, altitude: 20, altitudeReference: 'home' },
      { type: 'land', ...land },
    ];
    const flown = missionFeatures(aDrone({ mission: aMission({ items }) })).features;
    expect(flown[0]?.geometry).toMatchObject({ coordinates: way });
    expect(flown[2]?.properties).toEqual({ label: '2', words: 'Land', state: 'ahead' });
  });

  it('leads to where the drone would be brought down, unless that is where it is', () => {
    const [way, place] = landingFeatures(aDrone({ outlook: anOutlook() })).features;
    const coordinates = [
      [8.5456, 47.3977],
      [8.5456, 47.4022],
    ];
    expect(way?.geometry).toEqual({ type: 'LineString', coordinates });
    expect(place?.properties).toEqual({ label: 'lands here' });
    expect(landingFeatures(aDrone({ outlook: anOutlook({ latitude: 47.39772 }) })).features).toEqual([]);
    expect(landingFeatures(aDrone()).features).toEqual([]);
    expect(landingFeatures(null).features).toEqual([]);
  });

  it('draws a trail only from two points on', () => {
    const drones = [aDrone()];
    expect(trailFeatures(drones, null, () => [[[8, 47]]]).features).toEqual([]);
    const parts = trailFeatures(drones, 'd1', () => [
      [
        [8, 47],
        [8, 48],
      ],
      [[9, 47]],
      [
        [10, 47],
        [10, 48],
      ],
    ]);
    expect(parts.features.map((one) => one.properties)).toEqual([{ selected: true }, { selected: true }]);
  });
});

describe('metric grid', () => {
  const view = { west: 8.54, east: 8.55, south: 47.39, north: 47.4, metersPerPixel: 0.8 };

  it('has squares wide enough to see', () => {
    expect(gridStep(view)).toBe(100);
    expect(gridStep({ ...view, metersPerPixel: 0.1 })).toBe(10);
    expect(gridStep({ ...view, metersPerPixel: 5000 })).toBeNull();
  });

  it('keeps its lines where they are when the map moves a little', () => {
    const moved = { ...view, west: view.west + 0.0001, east: view.east + 0.0001 };
    const lines = new Set(gridLines(view).features.map((one) => one.geometry.coordinates[0]?.[0]));
    const shared = gridLines(moved).features.filter((one) =>
      lines.has(one.geometry.coordinates[0]?.[0] ?? 0),
    );
    expect(shared.length).toBeGreaterThan(5);
  });

  it('is absent when the whole country is shown', () => {
    expect(gridLines({ ...view, metersPerPixel: 600 }).features).toEqual([]);
  });
});
