import { flushSync } from 'svelte';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { aDrone, aMission, aRun, aRunWaypoint, aZone } from '../testing';
import { draftOf, newZone } from '../zones/zone-draft';
import { endMapModes, MAP_MODES, mapMode } from './map-modes.svelte';
import { Station } from './station.svelte';
import { FLEET_DRAFT } from './tours.svelte';

const HERE = { latitude: 47, longitude: 8 };

let station: Station;
let leave: () => void;

/** Switches each mode on, as the page does. */
const BEGIN: Record<string, () => void> = {
  'sending a drone': () => (station.dispatches.picking = true),
  'changing a run': () => {
    station.runs.apply(aRun());
    station.runs.show('r1');
    flushSync();
    station.runs.selectTool('add');
  },
  'drawing a zone': () => (station.zones.draft = newZone('polygon')),
  planning: () => station.planner.begin(FLEET_DRAFT),
};

beforeEach(() => {
  station = new Station();
  station.session = { name: 'ann', role: 'administrator', mustChangePassword: false, organisation: null };
  station.fleet.replaceAll([aDrone(), aDrone({ id: 'd2', name: 'Copter 2' })]);
  leave = $effect.root(() => endMapModes(station));
  flushSync();
});
afterEach(() => leave());

describe('each use of the map', () => {
  it.each(MAP_MODES.map((mode) => [mode.name]))('%s takes the clicks until its end', (name) => {
    BEGIN[name]?.();
    flushSync();
    expect(mapMode(station)?.name).toBe(name);
    mapMode(station)?.end(station);
    flushSync();
    expect(mapMode(station)).toBeNull();
  });

  it.each(MAP_MODES.map((mode) => [mode.name]))('%s ends when a run begins', (name) => {
    BEGIN[name]?.();
    flushSync();
    station.runs.apply(aRun({ id: 'r2' }));
    station.runs.show('r2');
    flushSync();
    expect(mapMode(station)).toBeNull();
  });

  it.each(MAP_MODES.map((mode) => [mode.name]))('%s ends when its user may do that no more', (name) => {
    BEGIN[name]?.();
    flushSync();
    station.session = { name: 'ann', role: 'viewer', mustChangePassword: false, organisation: null };
    flushSync();
    expect(mapMode(station)).toBeNull();
  });

  it.each(MAP_MODES.map((mode) => [mode.name]))('%s takes the place of where a drone was to go', (name) => {
    station.view.setTarget('d1', HERE);
    BEGIN[name]?.();
    flushSync();
    expect(station.view.target).toBeNull();
  });
});

describe('planning', () => {
  it('leaves no waypoint where somebody clicks on a run that was started from the plan', () => {
    station.planner.begin(FLEET_DRAFT);
    station.planner.addAt(HERE);
    flushSync();
    station.runs.apply(aRun());
    station.runs.show('r1');
    flushSync();
    mapMode(station)?.click(station, HERE);
    expect(station.planner.draftFor(FLEET_DRAFT)?.waypoints).toHaveLength(1);
  });

  it('ends when the mission of its drone is started', () => {
    station.view.select('d1');
    station.planner.begin('d1');
    flushSync();
    expect(station.planner.droneId).toBe('d1');
    const mission = aMission({ current: 0, total: 1, running: true });
    station.fleet.replaceAll([aDrone({ mission, version: 2 })]);
    flushSync();
    expect(station.planner.droneId).toBeNull();
    station.planner.begin('d1');
    flushSync();
    expect(station.planner.droneId, 'what comes after it may be planned').toBe('d1');
  });

  it('ends when another drone is chosen', () => {
    station.view.select('d1');
    station.planner.begin('d1');
    flushSync();
    station.view.select('d2');
    flushSync();
    expect(station.planner.droneId).toBeNull();
  });
});

describe('the place where a waypoint is to be moved to', () => {
  it('is asked for no longer when somebody has visited it', () => {
    station.runs.apply(aRun());
    station.runs.show('r1');
    flushSync();
    station.runs.choose('2');
    station.runs.selectTool('move');
    flushSync();
    expect(station.runs.tool).toBe('move');
    station.runs.apply(aRun({ waypoints: [aRunWaypoint('2', { state: 'visited' })] }));
    flushSync();
    expect(station.runs.tool).toBeNull();
  });
});

describe('the place where a drone is to go', () => {
  it('is meant no more when it has landed', () => {
    station.fleet.replaceAll([aDrone({ flight: 'inAir' })]);
    station.view.select('d1');
    station.view.setTarget('d1', HERE);
    flushSync();
    expect(station.view.target).not.toBeNull();
    station.fleet.replaceAll([aDrone({ flight: 'onGround' })]);
    flushSync();
    expect(station.view.target).toBeNull();
  });
});

describe('a zone that is being changed', () => {
  it('is not drawn on when somebody removes it', () => {
    const zone = aZone();
    station.zones.apply(zone);
    station.zones.draft = draftOf(zone);
    station.zones.applyRemoval(zone.id ?? '');
    expect(station.zones.draft).toBeNull();
  });
});
