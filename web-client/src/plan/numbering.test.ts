import { describe, expect, it } from 'vitest';
import { draftFeatures, missionFeatures } from '../map/features';
import { missionRows } from '../panel/mission-text';
import type { MissionItem } from '../api/types';
import { aDrone } from '../testing';
import { addWaypoint, emptyDraft, whyNotReady, type Draft } from './draft';
import { beginsWithTakeOff, takeOffHeight, waypointNumber } from './numbering';

const A = { latitude: 47.1, longitude: 8.1 };
const B = { latitude: 47.2, longitude: 8.2 };
const CANNOT = {
  allowed: false,
  why: 'This vehicle cannot take off.',
  code: 'capability-missing',
  mode: null,
};
const rover = aDrone({ kind: 'rover', actions: { takeOff: CANNOT } });

function plan(altitude: number | null = 30): Draft {
  return addWaypoint(addWaypoint(emptyDraft(), A, altitude), B, altitude);
}

function labels(features: { properties: unknown }[]): unknown[] {
  return features.map((one) => (one.properties as { label?: string }).label).filter(Boolean);
}

describe('numbers of items', () => {
  it('are the same in the list and on the map', () => {
    const items: MissionItem[] = [
      { type: 'takeOff', altitude: 20 },
      { type: 'waypoint', ...A, altitude: 20, altitudeReference: 'home' },
      { type: 'other', description: 'change speed' },
      { type: 'waypoint', ...B, altitude: 20, altitudeReference: 'home' },
    ];
    const mission = {
      items,
      current: 3,
      reached: [0],
      total: 4,
      running: true,
      state: null,
      notice: null,
      hash: null,
    };
    expect(missionRows(mission).map((line) => `${line.number} ${line.words}`)).toEqual([
      '1 Take off to 20 m',
      '2 Waypoint at 20 m',
      '3 change speed',
      '4 Waypoint at 20 m',
    ]);
    expect(labels(missionFeatures(aDrone({ mission })).features)).toEqual(['2', '4']);
  });

  it('of a plan are those that the vehicle will use after the upload', () => {
    expect(labels(draftFeatures(plan(), aDrone()).features)).toEqual(['2', '3']);
    expect(labels(draftFeatures({ ...plan(), takeOff: true }, aDrone()).features)).toEqual(['2', '3']);
    expect(waypointNumber(plan(), aDrone(), 0)).toBe(2);
  });

  it('begin with the first waypoint for vehicles that do not take off', () => {
    expect(beginsWithTakeOff(plan(), rover)).toBe(false);
    expect(labels(draftFeatures(plan(), rover).features)).toEqual(['1', '2']);
  });

  it('stand in the sentence that says what is missing', () => {
    const numbered = (index: number): number => waypointNumber(plan(), aDrone(), index);
    expect(whyNotReady(plan(null), numbered)).toBe('The altitude of item 2 must be -500 to 10000 m.');
  });

  it('come with the height of the take-off that the cloud puts in front', () => {
    expect(takeOffHeight(plan(30))).toBe(30);
    expect(takeOffHeight(plan(-20))).toBe(1);
    expect(takeOffHeight({ ...plan(30), takeOff: true, takeOffAltitude: 12 })).toBe(12);
    expect(takeOffHeight(emptyDraft())).toBeNull();
  });
});
