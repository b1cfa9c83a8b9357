import { cleanup, render, screen } from '@testing-library/svelte';
import { afterEach, describe, expect, it } from 'vitest';
import type { VehicleMission } from '../api/types';
import MissionProgress from './MissionProgress.svelte';

const MISSION: VehicleMission = {
  items: [
    { type: 'takeOff', altitude: 10 },
    { type: 'waypoint', latitude: 47.4, longitude: 8.5, altitude: 10, altitudeReference: 'home' },
  ],
  current: 1,
  reached: [0],
  total: 2,
  running: true,
  state: null,
  notice: null,
  hash: null,
};

describe('the mission of the vehicle', () => {
  afterEach(cleanup);

  it('says what was changed without the cloud', () => {
    const notice =
      'The mission on the vehicle is not the one that the cloud last knew: 2 items instead of 4.';
    render(MissionProgress, { mission: { ...MISSION, notice } });

    expect(screen.getByText(notice)).toBeDefined();
  });

  it('marks the item that the vehicle heads for', () => {
    render(MissionProgress, { mission: MISSION });

    const lines = screen.getAllByRole('listitem');
    expect(lines.map((line) => line.getAttribute('aria-current'))).toEqual([null, 'step']);
    expect(lines.map((line) => line.textContent?.trim().slice(0, 1))).toEqual(['1', '2']);
    expect(screen.getByText('Mission is running: item 2 of 2, 1 reached.')).toBeDefined();
  });
});
