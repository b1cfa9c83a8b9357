import { cleanup, fireEvent, render, screen, waitFor } from '@testing-library/svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import type { Prospect } from '../api/virtual';
import { STATION, Station } from '../state/station.svelte';
import { aCommand, aDrone, anAction } from '../testing';
import ControlLease from './ControlLease.svelte';
import EmergencyStop from './EmergencyStop.svelte';
import FlightControls from './FlightControls.svelte';
import PoolMembership from './PoolMembership.svelte';

afterEach(cleanup);

const ROOFS: Prospect = { name: 'Roofs', owner: 'olga', waypoints: 6, flies: true, why: null, code: null };

function aStation(): Station {
  const station = new Station();
  station.session = { name: 'ann', role: 'supervisor', mustChangePassword: false, organisation: null };
  station.connection.up();
  return station;
}

const context = (station: Station): Map<symbol, Station> => new Map([[STATION, station]]);

/** As a screen reader confirms a hold: two clicks. */
async function hold(name: RegExp): Promise<void> {
  const button = await screen.findByRole('button', { name });
  await fireEvent.click(button, { detail: 0 });
  await fireEvent.click(button, { detail: 0 });
}

describe('putting a drone into the warehouse', () => {
  function show(waiting: Prospect[]): Station {
    const station = aStation();
    vi.spyOn(station.rest.virtuals, 'prospects').mockResolvedValue({ inWarehouse: false, waiting });
    vi.spyOn(station.rest.virtuals, 'offer').mockResolvedValue([{ id: 'd1', name: 'Copter 1' }]);
    render(PoolMembership, { props: { drone: aDrone() }, context: context(station) });
    return station;
  }

  it('says what it takes off for before it is done, and asks', async () => {
    const station = show([
      { ...ROOFS, flies: false, why: 'It has too little battery.', code: 'battery-too-low' },
      ROOFS,
    ]);
    await fireEvent.click(screen.getByRole('button', { name: 'Let the cloud fly this drone…' }));
    expect((await screen.findByText(/arms and takes off at once/)).parentElement?.textContent).toContain(
      '“Roofs” of olga (6 waypoints)',
    );
    expect(screen.getByText(/It has too little battery/)).toBeDefined();
    expect(station.rest.virtuals.offer).not.toHaveBeenCalled();
    await hold(/Let the cloud fly this drone: it takes off/);
    await waitFor(() => expect(station.rest.virtuals.offer).toHaveBeenCalledWith('d1'));
  });

  it('says that nothing waits', async () => {
    const station = show([]);
    await fireEvent.click(screen.getByRole('button', { name: 'Let the cloud fly this drone…' }));
    expect(await screen.findByText(/No mission waits that Copter 1 could fly/)).toBeDefined();
    await hold(/^.*Let the cloud fly this drone$/);
    await waitFor(() => expect(station.rest.virtuals.offer).toHaveBeenCalled());
  });

  it('asks anew when something else would fly than what was shown', async () => {
    const station = show([]);
    await fireEvent.click(screen.getByRole('button', { name: 'Let the cloud fly this drone…' }));
    await screen.findByText(/No mission waits/);
    vi.mocked(station.rest.virtuals.prospects).mockResolvedValue({ inWarehouse: false, waiting: [ROOFS] });
    await hold(/^.*Let the cloud fly this drone$/);
    expect(await screen.findByText('The queue has changed meanwhile.')).toBeDefined();
    expect(station.rest.virtuals.offer).not.toHaveBeenCalled();
  });
});

describe('giving back control of a drone of the warehouse', () => {
  it('says what it takes off for, and asks', async () => {
    const station = aStation();
    station.virtuals.pool = [{ id: 'd1', name: 'Copter 1' }];
    station.leases.held = new Map([['d1', 7]]);
    vi.spyOn(station.rest.virtuals, 'prospects').mockResolvedValue({ inWarehouse: true, waiting: [ROOFS] });
    const release = vi.spyOn(station.leases, 'release').mockResolvedValue();
    const control = { state: 'held', holder: 'ann', explicit: true, epoch: 7, since: null, requests: [] };
    const drone = aDrone({ control: control as never });
    render(ControlLease, { props: { drone }, context: context(station) });
    await fireEvent.click(screen.getByRole('button', { name: 'Give back' }));
    expect(await screen.findByText(/arms and takes off at once/)).toBeDefined();
    expect(release).not.toHaveBeenCalled();
    await hold(/Give back: it takes off/);
    await waitFor(() => expect(release).toHaveBeenCalledWith('d1'));
  });
});

describe('arming in a mode that refuses it', () => {
  const drone = aDrone({
    mode: 'RTL',
    actions: {
      arm: { allowed: true, why: null, mode: 'GUIDED' },
      setMode: anAction(),
    },
  });

  function show(outcome: 'succeeded' | 'refused'): { station: Station; sent: string[] } {
    const station = aStation();
    const sent: string[] = [];
    vi.spyOn(station.rest, 'sendCommand').mockImplementation((_, request) => {
      sent.push(request.type === 'setMode' ? `setMode ${request.mode}` : request.type);
      return Promise.resolve(
        aCommand({
          id: request.id,
          type: request.type,
          phase: 'done',
          outcome: { result: outcome, by: 'vehicle', reason: 'It will not.', code: null },
        }),
      );
    });
    render(FlightControls, { props: { drone }, context: context(station) });
    return { station, sent };
  }

  it('changes to the mode that the cloud names, and arms then', async () => {
    const { sent } = show('succeeded');
    expect(screen.getByText(/It is not armed in RTL/)).toBeDefined();
    await hold(/Arm in GUIDED/);
    await waitFor(() => expect(sent).toEqual(['setMode GUIDED', 'arm']));
    expect(await screen.findByText(/^Mode: Done/)).toBeDefined();
    expect(await screen.findByText(/^Arm: Done/)).toBeDefined();
  });

  it('does not arm when the mode is refused, and says why', async () => {
    const { sent } = show('refused');
    await hold(/Arm in GUIDED/);
    expect(await screen.findByText(/^Mode: Refused by the vehicle. It will not./)).toBeDefined();
    expect(sent).toEqual(['setMode GUIDED']);
  });
});

describe('the emergency stop', () => {
  function show(change: Parameters<typeof aDrone>[0]): { sent: unknown[] } {
    const station = aStation();
    const sent: unknown[] = [];
    vi.spyOn(station.rest, 'sendCommand').mockImplementation((_, { id, ...request }) => {
      sent.push(request);
      return Promise.resolve(aCommand({ id, type: request.type }));
    });
    render(EmergencyStop, { props: { drone: aDrone(change) }, context: context(station) });
    return { sent };
  }
  const FLYING = {
    armed: true,
    flight: 'inAir' as const,
    actions: {
      forceDisarm: anAction(),
      emergencyStop: anAction('It cannot.'),
    },
  };

  it('wants two holds, and says that the drone falls', async () => {
    const { sent } = show(FLYING);
    expect(screen.getByText(/Copter 1 FALLS from where it is/)).toBeDefined();
    await hold(/Emergency stop: motors off/);
    expect(sent).toEqual([]);
    await hold(/Hold again: the motors stop now/);
    expect(sent).toEqual([{ type: 'disarm', force: true }]);
    expect(await screen.findByText(/^Emergency stop: Sent/)).toBeDefined();
  });

  it('forgets the first hold after three seconds', async () => {
    vi.useFakeTimers();
    try {
      const { sent } = show(FLYING);
      const press = async (): Promise<void> => {
        const button = screen.getByRole('button', { name: /Emergency stop|Hold again/ });
        await fireEvent.click(button, { detail: 0 });
        await fireEvent.click(button, { detail: 0 });
      };
      await press();
      await vi.advanceTimersByTimeAsync(3_001);
      await press();
      expect(sent).toEqual([]);
    } finally {
      vi.useRealTimers();
    }
  });

  it('stops a robot where it stands', async () => {
    const { sent } = show({ kind: 'rover', actions: { emergencyStop: anAction() } });
    await hold(/Emergency stop/);
    await hold(/Hold again/);
    expect(sent).toEqual([{ type: 'emergencyStop' }]);
  });

  it('is not for who may not, and says why', async () => {
    const why = 'Your role may look, not command; ask an administrator for the operator role.';
    const { sent } = show({ ...FLYING, actions: { forceDisarm: anAction(why) } });
    expect(screen.getByText(why)).toBeDefined();
    await hold(/Emergency stop/);
    await hold(/Emergency stop/);
    expect(sent).toEqual([]);
  });
});
