import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { tick } from 'svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { Problem } from '../api/problem';
import type { Command, Drone } from '../api/types';
import { MAP_MODES } from '../state/map-modes.svelte';
import { handleKey } from '../station/shortcuts';
import { STATION, Station } from '../state/station.svelte';
import { aCommand, aDrone, anAction } from '../testing';
import DronePanel from './DronePanel.svelte';
import EmergencyBar from './EmergencyBar.svelte';
import FlightControls from './FlightControls.svelte';
import MissionSection from './MissionSection.svelte';
import SpeedSection from './SpeedSection.svelte';

afterEach(cleanup);

const READY = anAction();

function aStation(): Station {
  const station = new Station();
  station.connection.up();
  station.session = { name: 'olga', role: 'operator', mustChangePassword: false, organisation: null };
  return station;
}

function aPlane(change: Partial<Drone> = {}): Drone {
  return aDrone({
    kind: 'fixedWing',
    vehicle: 'ArduPlane',
    mode: 'FBWA',
    actions: {
      arm: READY,
      setMode: READY,
      uploadMission: READY,
      startMission: READY,
      changeSpeed: READY,
      takeOff: { ...anAction('It takes off by a mission.'), code: 'capability-missing' },
      land: { ...anAction('It lands by a mission.'), code: 'capability-missing' },
    },
    ...change,
  });
}

const context = (station: Station): Map<symbol, Station> => new Map([[STATION, station]]);

const refused = (reason: string, code: string, type: Command['type']): Command =>
  aCommand({ type, phase: 'done', outcome: { result: 'refused', by: 'gate', reason, code } });

describe('the landing place of a mission', () => {
  function plan(drone: Drone = aDrone({ actions: { uploadMission: READY } })): Station {
    const station = aStation();
    station.planner.begin(drone.id);
    render(MissionSection, { props: { drone }, context: context(station) });
    return station;
  }

  const click = (station: Station, latitude: number): void => {
    MAP_MODES.find((mode) => mode.isOn(station))?.click(station, { latitude, longitude: 8.5 });
  };

  it('is set by the next click on the map, which adds no waypoint', async () => {
    const station = plan();
    click(station, 47.4);
    await fireEvent.change(screen.getByLabelText('At the end'), { target: { value: 'landAt' } });
    await tick();
    expect(screen.getByText('Set the landing place: on the map, or by coordinates.')).toBeDefined();
    click(station, 47.41);
    click(station, 47.42);
    await tick();

    expect(station.planner.draft?.waypoints.map(({ latitude }) => latitude)).toEqual([47.4, 47.42]);
    expect(screen.getByText('Land at 47.410000, 8.500000')).toBeDefined();
    expect((screen.getByLabelText('Coordinates') as HTMLInputElement).value).toBe('47.410000, 8.500000');
  });

  it('is set by fields, and goes to the vehicle with the height of its ground', async () => {
    const station = plan();
    const send = vi.spyOn(station.rest, 'sendCommand').mockResolvedValue(aCommand({ type: 'uploadMission' }));
    click(station, 47.4);
    await fireEvent.change(screen.getByLabelText('At the end'), { target: { value: 'landAt' } });
    await fireEvent.change(screen.getByLabelText('Coordinates'), { target: { value: 'nowhere' } });
    expect(screen.getByText(/These are no coordinates/)).toBeDefined();
    await fireEvent.change(screen.getByLabelText('Coordinates'), { target: { value: '47.39, 8.54' } });
    await fireEvent.input(screen.getByLabelText('Ground above home (m)'), { target: { value: '12' } });
    await fireEvent.click(screen.getByRole('button', { name: 'Upload mission' }));

    const land = { type: 'land', latitude: 47.39, longitude: 8.54, altitude: 12, altitudeReference: 'home' };
    expect(send).toHaveBeenCalledOnce();
    expect(send.mock.calls[0]?.[1]).toMatchObject({ items: [{ type: 'waypoint' }, land] });
  });

  it('is no longer waited for after Esc, and the editor stays', () => {
    const station = plan();
    station.planner.placesLanding = true;
    const escape = new KeyboardEvent('keydown', { key: 'Escape' });
    handleKey(escape, station, { search: () => undefined, row: () => undefined });
    expect(station.planner.placesLanding).toBe(false);
    expect(station.planner.droneId).toBe('d1');
  });

  it('shows a refusal at the item that it is about, until that is edited', async () => {
    const station = plan();
    const reason =
      'Item 2 (land): this vehicle (ArduPlane) lands on a straight way down to a place; it needs before it more.';
    vi.spyOn(station.rest, 'sendCommand').mockImplementation((_, request) =>
      Promise.resolve({ ...refused(reason, 'mission-not-for-vehicle', 'uploadMission'), id: request.id }),
    );
    click(station, 47.4);
    await fireEvent.change(screen.getByLabelText('At the end'), { target: { value: 'land' } });
    await fireEvent.click(screen.getByRole('button', { name: 'Upload mission' }));
    const item = (await screen.findByText(/^This vehicle \(ArduPlane\) lands on a straight way/)).closest(
      'li',
    );
    expect(item?.textContent).toContain('2');
    expect(item?.textContent).toContain('Land');

    click(station, 47.41);
    await tick();
    expect(screen.queryByText(/^This vehicle \(ArduPlane\) lands on/)).toBeNull();
  });

  it('shows a value that the cloud does not take at its item, the take-off of the cloud counted', async () => {
    const station = plan(aDrone({ actions: { uploadMission: READY, takeOff: anAction('Arm first.') } }));
    vi.spyOn(station.rest, 'sendCommand').mockRejectedValue(
      new Problem({
        status: 422,
        detail: 'Item 2 (waypoint): too high.',
        field: 'items[1].altitude',
        code: 'mission-unusable',
      }),
    );
    click(station, 47.4);
    click(station, 47.41);
    await fireEvent.click(screen.getByRole('button', { name: 'Upload mission' }));
    const item = (await screen.findByText('Too high.')).closest('li');
    expect(item?.querySelector('.mark')?.textContent).toBe('3');
    expect(screen.getByText('Not uploaded: item 3 above says why.')).toBeDefined();
  });
});

describe('a plane', () => {
  it('takes off and lands by a mission, which is begun with both', async () => {
    const station = aStation();
    const drone = aPlane({ motion: { groundSpeed: 0, airSpeed: null, climbRate: 0, heading: 90 } });
    render(FlightControls, { props: { drone }, context: context(station) });
    expect(screen.queryByRole('button', { name: 'Take off' })).toBeNull();
    await fireEvent.click(screen.getByRole('button', { name: 'Plan take-off and landing' }));

    const draft = station.planner.draft;
    expect(station.planner.droneId).toBe('d1');
    expect(draft).toMatchObject({ takeOff: true, takeOffAltitude: 50, ending: 'land' });
    expect(draft?.landing?.place).toEqual({ latitude: 47.3977, longitude: 8.5456 });
    // It looks east: the approach begins in the west.
    const approach = draft?.waypoints[0];
    expect(approach?.latitude).toBeCloseTo(47.3977, 5);
    expect(approach?.longitude).toBeLessThan(8.5456);
    station.planner.addAt({ latitude: 47.5, longitude: 8.6 });
    expect(station.planner.draft?.waypoints.map(({ latitude }) => latitude)[0]).toBe(47.5);
  });

  it('is not let land without a place', async () => {
    const station = aStation();
    station.planner.begin('d1');
    station.planner.addAt({ latitude: 47.4, longitude: 8.5456 });
    render(MissionSection, { props: { drone: aPlane() }, context: context(station) });
    await fireEvent.change(screen.getByLabelText('At the end'), { target: { value: 'land' } });
    expect(screen.getByText('A plane lands at a place: choose “land at a place”.')).toBeDefined();
    expect(screen.getByRole('button', { name: 'Upload mission' }).getAttribute('aria-disabled')).toBe('true');
  });

  it('in the air begins a mission that lands alone, and leaves the old draft to undo', async () => {
    const station = aStation();
    station.planner.begin('d1');
    station.planner.addAt({ latitude: 47.5, longitude: 8.6 });
    station.planner.stop();
    render(FlightControls, { props: { drone: aPlane({ flight: 'inAir' }) }, context: context(station) });
    await fireEvent.click(screen.getByRole('button', { name: 'Plan landing' }));
    expect(station.planner.draft).toMatchObject({ takeOff: false, ending: 'land' });
    expect(station.planner.draft?.waypoints).toHaveLength(1);
    station.planner.undo();
    expect(station.planner.draft?.waypoints[0]?.latitude).toBe(47.5);
  });
});

describe('a rover', () => {
  it('is planned nothing to take off from, and nothing to land on', () => {
    const station = aStation();
    station.planner.begin('d1');
    render(MissionSection, { props: { drone: aDrone({ kind: 'rover' }) }, context: context(station) });
    expect(screen.queryByLabelText('Take-off height')).toBeNull();
    const ends = [...screen.getByLabelText('At the end').querySelectorAll('option')];
    expect(ends.map(({ value }) => value)).toEqual(['hold', 'returnToLaunch']);
  });
});

describe('a copter that does not know where it is', () => {
  it('is offered what it can do without that', async () => {
    const station = aStation();
    const sent = vi.spyOn(station.rest, 'sendCommand').mockImplementation((_, request) =>
      Promise.resolve({
        ...refused('Mode change to LOITER failed: requires position.', 'position-missing', request.type),
        id: request.id,
      }),
    );
    const drone = aDrone({
      mode: 'STABILIZE',
      modes: ['STABILIZE', 'ALT_HOLD', 'LOITER'],
      actions: { hold: READY, land: READY, setMode: READY, returnToLaunch: READY },
    });
    render(EmergencyBar, { props: { drone }, context: context(station) });
    expect(screen.queryByRole('button', { name: 'Change to ALT_HOLD' })).toBeNull();
    await fireEvent.click(screen.getByRole('button', { name: 'Hold' }));
    await fireEvent.click(await screen.findByRole('button', { name: 'Change to ALT_HOLD' }));
    await fireEvent.click(screen.getByRole('button', { name: 'Land here' }));

    expect(sent.mock.calls.map(([, request]) => request)).toMatchObject([
      { type: 'hold' },
      { type: 'setMode', mode: 'ALT_HOLD' },
      { type: 'land' },
    ]);
  });
});

describe('a change of speed', () => {
  it.each([
    ['multicopter', '0.2 to 30 m/s', '31', 'The speed must be 0.2 to 30 m/s.'],
    ['fixedWing', '3 to 100 m/s', '2', 'The speed must be 3 to 100 m/s.'],
    ['rover', '0.1 to 30 m/s', '', 'The speed must be 0.1 to 30 m/s.'],
  ] as const)('of a %s has its bounds', async (kind, range, wrong, sentence) => {
    const station = aStation();
    const send = vi.spyOn(station.rest, 'sendCommand').mockResolvedValue(aCommand({ type: 'changeSpeed' }));
    render(SpeedSection, { props: { drone: aPlane({ kind }) }, context: context(station) });
    expect(screen.getByText(range)).toBeDefined();
    await fireEvent.click(screen.getByRole('button', { name: /^Change speed/ }));
    const field = screen.getByLabelText(/m\/s/);
    const press = screen.getAllByRole('button', { name: 'Change speed' })[1] as HTMLElement;
    await fireEvent.input(field, { target: { value: wrong } });
    expect(screen.getByText(sentence)).toBeDefined();
    await fireEvent.click(press);
    expect(send).not.toHaveBeenCalled();
    await fireEvent.input(field, { target: { value: '7.5' } });
    await fireEvent.click(press);
    expect(send).toHaveBeenCalledWith('d1', expect.objectContaining({ metersPerSecond: 7.5 }));
  });

  it('is in the panel of a drone that can', () => {
    const station = aStation();
    render(DronePanel, { props: { drone: aPlane() }, context: context(station) });
    expect(screen.getByText('Change speed')).toBeDefined();
    cleanup();
    render(DronePanel, { props: { drone: aPlane({ actions: { arm: READY } }) }, context: context(station) });
    expect(screen.queryByText('Change speed')).toBeNull();
  });
});
