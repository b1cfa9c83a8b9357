import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { tick } from 'svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import type { Drone, MissionItem } from '../api/types';
import { addWaypoint } from '../plan/draft';
import { STATION, Station } from '../state/station.svelte';
import { aCommand, aDrone, aMission, anAction } from '../testing';
import MissionSection from './MissionSection.svelte';

const READY = anAction();
const ITEMS: MissionItem[] = [
  { type: 'takeOff', altitude: 20 },
  { type: 'waypoint', latitude: 47.3987, longitude: 8.5456, altitude: 20, altitudeReference: 'home' },
];

function flyable(change: Partial<Drone> = {}): Drone {
  return aDrone({
    actions: { takeOff: READY, uploadMission: READY, startMission: READY },
    mission: {
      items: ITEMS,
      current: 0,
      reached: [],
      total: 2,
      running: false,
      state: null,
      notice: null,
      hash: null,
    },
    ...change,
  });
}

function stationWithLink(): Station {
  const station = new Station();
  station.connection.up();
  station.session = { name: 'olga', role: 'operator', mustChangePassword: false, organisation: null };
  return station;
}

function show(station: Station, drone: Drone) {
  return render(MissionSection, { props: { drone }, context: new Map([[STATION, station]]) });
}

afterEach(cleanup);

describe('mission section', () => {
  it('starts with what the vehicle shall do when the cloud is lost, and says what that means', async () => {
    const station = stationWithLink();
    const send = vi.spyOn(station.rest, 'sendCommand').mockResolvedValue(aCommand({ type: 'startMission' }));
    show(station, flyable());
    expect(screen.getByText(/flies its mission to the end/)).toBeDefined();

    await fireEvent.change(screen.getByLabelText('If the cloud is lost'), { target: { value: 'rtl' } });
    expect(screen.getByText(/aborts its mission and returns to launch/)).toBeDefined();
    await fireEvent.click(screen.getByRole('button', { name: 'Start mission' }));

    expect(send).toHaveBeenCalledWith(
      'd1',
      expect.objectContaining({ type: 'startMission', onCloudLoss: 'rtl' }),
    );
  });

  it('brings the start into view after an upload, without a button that a held key could press', async () => {
    const scrolled = vi.spyOn(HTMLElement.prototype, 'scrollIntoView');
    const station = stationWithLink();
    station.planner.begin('d1');
    station.planner.edit((draft) => addWaypoint(draft, { latitude: 47.4, longitude: 8.5 }, 20));
    station.planner.markSent();
    station.planner.markUploaded('d1');
    const { rerender } = show(station, flyable({ mission: aMission() }));
    await tick();
    scrolled.mockClear();
    await rerender({ drone: flyable() });

    const last = scrolled.mock.contexts.at(-1) as HTMLElement;
    expect(last.contains(screen.getByRole('button', { name: 'Start mission' }))).toBe(true);
    expect(document.activeElement?.textContent).toBe('Mission');
    expect(station.planner.uploaded).toBeNull();
  });

  it('wants a far waypoint to be looked at before it is uploaded', async () => {
    const station = stationWithLink();
    const send = vi.spyOn(station.rest, 'sendCommand').mockResolvedValue(aCommand({ type: 'uploadMission' }));
    station.planner.begin('d1');
    station.planner.edit((draft) => addWaypoint(draft, { latitude: 47.6, longitude: 8.5456 }, 20));
    show(station, flyable());
    const upload = screen.getByRole('button', { name: 'Upload mission' });

    expect(screen.getByText(/^Item 2 is 22\.\d+ km away from the drone\.$/)).toBeDefined();
    await fireEvent.click(upload);
    expect(send).not.toHaveBeenCalled();
    await fireEvent.click(screen.getByLabelText('This is intended'));
    await fireEvent.click(upload);

    expect(send).toHaveBeenCalledOnce();
  });

  it('says why Start is not to be pressed while the mission is flown', async () => {
    const station = stationWithLink();
    const send = vi.spyOn(station.rest, 'sendCommand');
    const mission = {
      items: ITEMS,
      current: 1,
      reached: [0],
      total: 2,
      running: true,
      state: 'running',
      notice: null,
      hash: null,
    } as const;
    show(station, flyable({ flight: 'inAir', mission: { ...mission, reached: [0] } }));
    const start = screen.getByRole('button', { name: 'Start mission' });
    expect(start.getAttribute('aria-disabled')).toBe('true');
    expect(screen.getByText('It is running.')).toBeDefined();
    expect(screen.queryByLabelText('If the cloud is lost')).toBeNull();
    await fireEvent.click(start);
    expect(send).not.toHaveBeenCalled();
  });

  it('says calmly that the vehicle has forgotten its mission', () => {
    const notice = 'The vehicle holds no mission now; the last one that the cloud knew had 4 items.';
    const mission = aMission({ items: [], total: 0, notice });
    show(stationWithLink(), flyable({ mission }));

    expect(screen.getByText(notice).classList.contains('calm')).toBe(true);
  });
});
