import { describe, expect, it } from 'vitest';
import type { TrackPoint } from '../api/flights';
import { Track } from './track';

function point(second: number, latitude: number | null, more: Partial<TrackPoint> = {}): TrackPoint {
  return {
    at: new Date(second * 1000).toISOString(),
    latitude,
    longitude: latitude === null ? null : 8,
    altitudeAmsl: null,
    altitudeAboveHome: 10 * second,
    heading: 90,
    groundSpeed: null,
    climbRate: null,
    batteryPercent: 80,
    armed: true,
    mode: 'AUTO',
    flight: null,
    link: 'live',
    ...more,
  };
}

describe('a track', () => {
  it('is between two points on the line between them', () => {
    const track = new Track([point(0, 47), point(2, 48)]);

    expect(track.at(500)).toMatchObject({ latitude: 47.25, longitude: 8, altitude: 5, battery: 80 });
  });

  it('is nowhere before its beginning and stays where it ended', () => {
    const track = new Track([point(10, 47), point(11, 48)]);

    expect(track.at(9_999)).toBeNull();
    expect(track.at(99_000)).toMatchObject({ latitude: 48 });
    expect(new Track([]).at(0)).toBeNull();
  });

  it('does not make up a way through a long silence', () => {
    const track = new Track([point(0, 47), point(1, 47.1), point(60, 48), point(61, 48.1)]);

    expect(track.lines().map((line) => line.length)).toEqual([2, 2]);
    expect(track.at(30_000)).toMatchObject({ latitude: 47.1 });
  });

  it('passes over points that do not say where they are', () => {
    const track = new Track([point(0, 47), point(1, null), point(2, 48)]);

    expect(track.at(1_000)).toMatchObject({ latitude: 47.5 });
  });

  it('finds each moment of a long flight', () => {
    const track = new Track(Array.from({ length: 10_000 }, (_, second) => point(second, second / 1_000)));

    for (const second of [0, 1, 4_711, 9_998, 9_999]) {
      expect(track.at(second * 1000)?.latitude).toBeCloseTo(second / 1_000, 9);
    }
  });
});
