import { cleanup, render, screen, within } from '@testing-library/svelte';
import { flushSync, tick } from 'svelte';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import Readings from '../follow/Readings.svelte';
import { STATION, Station } from '../state/station.svelte';
import { aDrone, aFollowNow, aRun } from '../testing';
import Workspace from './Workspace.svelte';

const shown = vi.hoisted(() => ({ drones: null as unknown }));

vi.mock('../map/flight-map', () => ({
  FlightMap: class {
    show(layer: string, features: unknown): void {
      if (layer === 'drones') {
        shown.drones = features;
      }
    }
    fit(): void {}
    flyTo(): void {}
    setPlanning(): void {}
    dispose(): void {}
  },
}));

/** Buttons that command the drone, or change control of it. */
const COMMANDS = /^(Arm|Disarm|Take off|Hold|Return to launch|Land|Take control|Keep control)/;

function aStation(): Station {
  const station = new Station();
  station.session = { name: 'ann', role: 'administrator', mustChangePassword: false, organisation: null };
  station.connection.up();
  station.connection.received();
  station.clock.synchronise('2026-01-01T12:00:07Z');
  station.fleet.replaceAll([
    aDrone({
      flight: 'inAir',
      armed: true,
      motion: { groundSpeed: 7.5, airSpeed: null, climbRate: 0, heading: 40 },
      attitude: { roll: 3, pitch: 1, yaw: 40 },
      actions: Object.fromEntries(
        ['arm', 'disarm', 'takeOff', 'hold', 'returnToLaunch', 'land', 'setMode'].map((kind) => [
          kind,
          { allowed: true, why: null },
        ]),
      ),
    }),
  ]);
  return station;
}

async function show(station: Station): Promise<void> {
  vi.stubGlobal('fetch', () => Promise.reject(new Error('no server here')));
  render(Workspace, { context: new Map([[STATION, station]]) });
  await vi.waitFor(() => expect(shown.drones).not.toBeNull());
  await tick();
}

beforeEach(() => {
  shown.drones = null;
  Object.defineProperty(document, 'fonts', {
    configurable: true,
    value: { load: () => Promise.resolve([]) },
  });
});
afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

const body = (): Element => document.querySelector('.body') as Element;
const mapSays = (): string => JSON.stringify(shown.drones);

describe('a page without a connection to the cloud', () => {
  it('says so, shows all of it as old with its age, and commands nothing', async () => {
    const station = aStation();
    station.view.select('d1');
    await show(station);
    expect(body().classList.contains('stale')).toBe(false);
    expect(mapSays()).toContain('"opacity":1');

    station.connection.down();
    flushSync();

    expect(screen.getByRole('alert').textContent).toContain('No connection to the cloud for');
    expect(screen.getByText(/^Offline for/)).toBeDefined();
    expect(screen.queryByText('Connected')).toBeNull();
    expect(body().classList.contains('stale')).toBe(true);
    expect(screen.getByText(/these are the last values, 7 s ago/)).toBeDefined();
    expect(screen.getByRole('img', { name: 'Attitude unknown' })).toBeDefined();
    expect(
      within(screen.getByRole('region', { name: 'Drone Copter 1' })).getByText(/Offline ·/),
    ).toBeDefined();
    expect(mapSays()).toContain('"opacity":0.55');
    expect(mapSays()).toMatch(/"age":"[^"]+"/);
    const commands = screen.getAllByRole('button', { name: COMMANDS });
    expect(commands.length).toBeGreaterThan(5);
    for (const button of commands) {
      expect(button.getAttribute('aria-disabled'), button.textContent).toBe('true');
    }
    expect(screen.getByRole('combobox', { name: 'Flight mode' }).hasAttribute('disabled')).toBe(true);
    expect(screen.getAllByText('No connection to the cloud.').length).toBeGreaterThan(0);
  });

  it('is as before at once when the connection is back', async () => {
    const station = aStation();
    station.view.select('d1');
    await show(station);
    station.connection.down();
    flushSync();
    station.connection.up();
    flushSync();
    expect(body().classList.contains('stale')).toBe(false);
    expect(screen.getByText('Connected')).toBeDefined();
    expect(screen.getByRole('button', { name: /^Arm/ }).getAttribute('aria-disabled')).toBe('false');
    expect(mapSays()).not.toContain('"opacity":0.55');
  });

  it('says of a run how long ago it stood so', async () => {
    const station = aStation();
    station.runs.apply(aRun());
    station.runs.show('r1');
    await show(station);
    station.connection.down();
    flushSync();
    expect(screen.getByText(/No connection to the cloud for .*: this is how it stood/)).toBeDefined();
    for (const name of [/Pause/, /Hold all drones/, /^End/]) {
      const button = screen.getByRole('button', { name });
      expect(button.hasAttribute('disabled') || button.getAttribute('aria-disabled') === 'true').toBe(true);
    }
  });
});

describe('the page of a phone without a connection to the cloud', () => {
  it('calls its figures old', () => {
    const station = aStation();
    const now = aFollowNow('2026-01-01T12:00:00Z');
    render(Readings, {
      props: { drone: aDrone(), away: 8, now },
      context: new Map([[STATION, station]]),
    });
    expect(screen.queryByText(/figures are old/)).toBeNull();
    station.connection.down();
    flushSync();
    expect(screen.getByText(/No connection to the cloud for .*: these figures are old/)).toBeDefined();
    expect(document.querySelector('dl')?.classList.contains('silent')).toBe(true);
  });
});
