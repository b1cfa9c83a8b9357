import { describe, expect, it } from 'vitest';
import type { MissionItem } from '../api/types';
import { plausibilityWarnings } from './plausible';

const HERE = { latitude: 47, longitude: 8 };
const CLIMB: MissionItem = { type: 'takeOff', altitude: 20 };

function sentencesOf(items: MissionItem[], from: typeof HERE | null): string[] {
  return plausibilityWarnings(items, from).map((warning) => warning.sentence);
}

function at(latitude: number, altitude = 20): MissionItem {
  return { type: 'waypoint', latitude, longitude: 8, altitude, altitudeReference: 'home' };
}

describe('warnings about a mission', () => {
  it('are none for an ordinary one', () => {
    expect(sentencesOf([CLIMB, at(47.001), at(47.002, 120)], HERE)).toEqual([]);
  });

  it('name a waypoint more than 10 km away from the drone', () => {
    expect(sentencesOf([CLIMB, at(47.1)], HERE)).toEqual(['Item 2 is 11.12 km away from the drone.']);
    expect(sentencesOf([CLIMB, at(47.1)], null)).toEqual([]);
  });

  it('name only the farthest of many', () => {
    expect(sentencesOf([at(47.1), at(47.12), at(47.11)], HERE)).toEqual([
      '3 places are more than 10 km away from the drone; item 2 is 13.34 km away.',
    ]);
  });

  it('name a leg of more than 20 km and a way of more than 50 km', () => {
    expect(sentencesOf([at(47), at(47.5)], null)).toEqual([
      'From item 1 to item 2 it is 55.60 km.',
      'The whole way is 55.60 km.',
    ]);
  });

  it('name what is lower than home or higher than 500 m above it', () => {
    expect(sentencesOf([CLIMB, at(47, -5), at(47, 501)], HERE)).toEqual([
      'Item 2 is at −5 m, lower than home.',
      'Item 3 is 501 m above home.',
    ]);
  });

  it('are the same warning while the drone moves, and a new one when the waypoint does', () => {
    const far = (latitude: number, from: typeof HERE): string | undefined =>
      plausibilityWarnings([CLIMB, at(latitude)], from)[0]?.key;
    expect(far(47.1, { latitude: 47.001, longitude: 8 })).toBe(far(47.1, HERE));
    expect(far(47.2, HERE)).not.toBe(far(47.1, HERE));
  });
});
