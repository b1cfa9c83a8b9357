import { describe, expect, it } from 'vitest';
import type { MissionItem } from '../api/types';
import {
  addPasted,
  addWaypoint,
  changeWaypoint,
  draftOf,
  emptyDraft,
  itemsOf,
  removeWaypoint,
  shiftWaypoint,
  whyNotReady,
  type Draft,
} from './draft';

const A = { latitude: 47.1, longitude: 8.1 };
const B = { latitude: 47.2, longitude: 8.2 };
const C = { latitude: 47.3, longitude: 8.3 };

function draftWith(...places: { latitude: number; longitude: number }[]): Draft {
  return places.reduce((draft, place) => addWaypoint(draft, place, 20), emptyDraft());
}

const latitudes = (draft: Draft): number[] => draft.waypoints.map((waypoint) => waypoint.latitude);

describe('draft', () => {
  it('becomes the items of the contract', () => {
    const draft: Draft = { ...draftWith(A), takeOff: true, takeOffAltitude: 15, ending: 'returnToLaunch' };
    expect(itemsOf(draft)).toEqual([
      { type: 'takeOff', altitude: 15 },
      { type: 'waypoint', ...A, altitude: 20, altitudeReference: 'home' },
      { type: 'returnToLaunch' },
    ]);
  });

  it('comes back from items unchanged', () => {
    const items: MissionItem[] = [
      { type: 'takeOff', altitude: 15 },
      { type: 'waypoint', ...A, altitude: 20, altitudeReference: 'home', holdSeconds: 5 },
      { type: 'waypoint', ...B, altitude: 600, altitudeReference: 'amsl' },
      { type: 'land' },
    ];
    const { draft, leftOut } = draftOf(items);
    expect(itemsOf(draft)).toEqual(items);
    expect(leftOut).toBe(0);
    expect(whyNotReady(draft)).toBeNull();
  });

  it('keeps the place of a landing through items and back', () => {
    const items: MissionItem[] = [
      { type: 'waypoint', ...A, altitude: 40, altitudeReference: 'amsl' },
      { type: 'land', ...B, altitude: 410, altitudeReference: 'amsl' },
    ];
    expect(itemsOf(draftOf(items).draft)).toEqual(items);
    const bare: MissionItem[] = [items[0] as MissionItem, { type: 'land', ...B }];
    expect(itemsOf(draftOf(bare).draft)).toEqual(bare);
    const none: MissionItem[] = [items[0] as MissionItem, { type: 'land', latitude: null, longitude: null }];
    expect(itemsOf(draftOf(none).draft).at(-1)).toEqual({ type: 'land' });
  });

  it('counts what the editor cannot express', () => {
    const { draft, leftOut } = draftOf([
      { type: 'other', description: 'DO_SET_SERVO' },
      { type: 'waypoint', ...A, altitude: 20, altitudeReference: 'home' },
    ]);
    expect(leftOut).toBe(1);
    expect(draft.waypoints).toHaveLength(1);
  });

  it('reorders by keyboard and stays whole at the ends', () => {
    const draft = draftWith(A, B, C);
    const last = draft.waypoints[2]?.key ?? 0;
    expect(latitudes(shiftWaypoint(draft, last, -1))).toEqual([47.1, 47.3, 47.2]);
    expect(shiftWaypoint(draft, last, 1)).toBe(draft);
  });

  it('removes and changes one waypoint only', () => {
    const draft = draftWith(A, B);
    const first = draft.waypoints[0]?.key ?? 0;
    expect(latitudes(removeWaypoint(draft, first))).toEqual([47.2]);
    const changed = changeWaypoint(draft, first, { altitude: 99 });
    expect(changed.waypoints.map((waypoint) => waypoint.altitude)).toEqual([99, 20]);
  });

  it('never gives two waypoints one key', () => {
    const removed = removeWaypoint(draftWith(A, B), 2);
    const keys = addWaypoint(removed, C, 20).waypoints.map((waypoint) => waypoint.key);
    expect(new Set(keys).size).toBe(keys.length);
  });

  it('adds pasted lines and hands back the unreadable ones', () => {
    const { draft, unreadable } = addPasted(emptyDraft(), '47.1, 8.1\nnonsense', 30);
    expect(draft.waypoints).toHaveLength(1);
    expect(draft.waypoints[0]?.altitude).toBe(30);
    expect(unreadable).toEqual(['nonsense']);
  });

  it('says what is missing before it can be uploaded', () => {
    expect(whyNotReady(emptyDraft())).toContain('Add a waypoint');
    const without = changeWaypoint(draftWith(A, B), 2, { altitude: null });
    expect(whyNotReady(without)).toBe('The altitude of item 2 must be -500 to 10000 m.');
    expect(whyNotReady({ ...draftWith(A), takeOff: true, takeOffAltitude: 0 })).toBe(
      'The altitude of the take-off must be 1 to 500 m.',
    );
    const absurd = changeWaypoint(draftWith(A), 1, { altitude: -10_000, altitudeReference: 'amsl' });
    expect(whyNotReady(absurd)).toContain('-500 to 10000 m');
  });
});
